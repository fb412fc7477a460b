// Leaves: up to 16 primitives of one kind as a structure of arrays.
//
// Each number of the primitives has a row of 16 words, one cache line. A leaf of spheres is five
// rows       cx cy cz radius id            (320 bytes),
// a leaf of rectangles six rows   u0 u1 v0 v1 k id   (384 bytes; see Rectangle),
// one of triangles ten            x y z of each vertex, id   (640 bytes),
// one of cylinders eight          x y z of both ends, radius, id   (512 bytes).
// Lanes in use come first, by ascending id. The others are shapes that nothing hits: zeros, and for
// a rectangle u0 = +infinity and u1 = -infinity; their id is kNoPrim.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "scene/shapes.h"

namespace dapple {

inline constexpr std::size_t kLeafWidth = 16;

// Numbers of a shape; its row of ids follows them.
constexpr std::size_t leaf_id_row(ShapeKind kind) {
  if (kind == ShapeKind::sphere) return 4;
  if (kind == ShapeKind::triangle) return 9;
  if (kind == ShapeKind::cylinder) return 7;
  return 5;
}
constexpr std::size_t leaf_rows(ShapeKind kind) { return leaf_id_row(kind) + 1; }
inline constexpr std::size_t kMaxLeafRows = 10;

// One row: what leaves are counted and addressed in.
struct alignas(64) LeafRow {
  std::uint32_t words[kLeafWidth];
};
static_assert(sizeof(LeafRow) == 64);

// A leaf, or one lane of it: kind, lane and first row in 64 bits.
struct LeafRef {
  std::uint64_t bits = 0;

  LeafRef() = default;
  constexpr LeafRef(ShapeKind kind, std::uint64_t first_row)
      : bits(static_cast<std::uint64_t>(kind) << 60 | first_row << 4) {}

  constexpr ShapeKind kind() const { return static_cast<ShapeKind>(bits >> 60); }
  constexpr std::size_t first_row() const { return (bits & ~(std::uint64_t{15} << 60)) >> 4; }
  constexpr std::size_t lane_index() const { return bits & 15; }
  constexpr LeafRef lane(std::size_t i) const {
    LeafRef result = *this;
    result.bits |= i;
    return result;
  }
};

// The number in a row for one lane, as stored and as the float it usually is.
inline std::uint32_t leaf_word(const LeafRow* rows, LeafRef lane, std::size_t row) {
  return rows[lane.first_row() + row].words[lane.lane_index()];
}
inline float leaf_float(const LeafRow* rows, LeafRef lane, std::size_t row) {
  return std::bit_cast<float>(leaf_word(rows, lane, row));
}
inline std::uint32_t leaf_prim_id(const LeafRow* rows, LeafRef lane) {
  return leaf_word(rows, lane, leaf_id_row(lane.kind()));
}

}  // namespace dapple
