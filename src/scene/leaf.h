// Leaves: up to 16 primitives of one kind as a structure of arrays.
//
// Each number of the primitives has a row of 16 words, one cache line. A leaf of spheres is five
// rows       cx cy cz radius id            (320 bytes),
// a leaf of rectangles six rows   u0 u1 v0 v1 k id   (384 bytes; see Rectangle),
// one of triangles ten            x y z of each vertex, id   (640 bytes),
// one of cylinders eight          x y z of both ends, radius, id   (512 bytes),
// one of instances seven          the box in the world: lower x y z, upper x y z, id (448 bytes).
// In the compact form a leaf of triangles is only four rows, the indices of the three vertices and
// the id (256 bytes); the scene has their positions. Lanes in use come first, by ascending id. The
// others are shapes that nothing hits: zeros, but for a rectangle u0 = +infinity and u1 = -infinity
// and for an instance the empty box; their id is kNoPrim.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "scene/shapes.h"

namespace dapple {

inline constexpr std::size_t kLeafWidth = 16;

// What stands in the leaves of triangles.
enum class LeafForm {
  whole,    // all coordinates, ready to be tested
  compact,  // indices of vertices: a third of the memory, slower
};

// Numbers of a shape; its row of ids follows them.
constexpr std::size_t leaf_id_row(ShapeKind kind, LeafForm form = LeafForm::whole) {
  if (kind == ShapeKind::sphere) return 4;
  if (kind == ShapeKind::triangle) return form == LeafForm::compact ? 3 : 9;
  if (kind == ShapeKind::cylinder) return 7;
  if (kind == ShapeKind::instance) return 6;
  return 5;
}
constexpr std::size_t leaf_rows(ShapeKind kind, LeafForm form = LeafForm::whole) {
  return leaf_id_row(kind, form) + 1;
}
inline constexpr std::size_t kMaxLeafRows = 10;

// One row: what leaves are counted and addressed in.
struct alignas(64) LeafRow {
  std::uint32_t words[kLeafWidth];
};
static_assert(sizeof(LeafRow) == 64);

// All that is needed to read leaves.
struct LeafArrays {
  const LeafRow* rows = nullptr;
  const Vec3f* positions = nullptr;  // of the scene's vertices, if the leaves are compact
  std::uint32_t last_vertex = 0;     // then

  LeafForm form() const { return positions == nullptr ? LeafForm::whole : LeafForm::compact; }
};

// A leaf, or one lane of it: kind (4 bits), instance (28), first row (28) and lane (4). The lower
// half counts the words of the rows up to the lane's first number.
struct LeafRef {
  std::uint64_t bits = 0;

  LeafRef() = default;
  constexpr LeafRef(ShapeKind kind, std::uint64_t first_row)
      : bits(static_cast<std::uint64_t>(kind) << 60 | first_row << 4) {}

  constexpr ShapeKind kind() const { return static_cast<ShapeKind>(bits >> 60); }
  constexpr std::size_t first_row() const { return (bits & 0xffffffffu) >> 4; }
  constexpr std::size_t lane_index() const { return bits & 15; }
  constexpr LeafRef lane(std::size_t i) const {
    LeafRef result = *this;
    result.bits |= i;
    return result;
  }

  static constexpr std::size_t kMaxInstances = (std::size_t{1} << 28) - 1;
  // 0 for what stands in the world itself, else 1 + the index of the instance it is seen through.
  constexpr std::uint32_t seen_through() const {
    return static_cast<std::uint32_t>(bits >> 32) & 0x0fffffffu;
  }
  constexpr bool in_instance() const { return seen_through() != 0; }
  constexpr std::size_t instance_index() const { return seen_through() - 1; }
  constexpr LeafRef through(std::size_t instance) const {
    LeafRef result = *this;
    result.bits |= (std::uint64_t{instance} + 1) << 32;
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
