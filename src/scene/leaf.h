// Leaves: runs of primitives of one kind, as a structure of arrays in 32-bit words.
//
// A leaf of n spheres is 5n words     cx[n] cy[n] cz[n] radius[n] id[n],
// a leaf of n rectangles 6n words     u0[n] u1[n] v0[n] v1[n] k[n] id[n]   (see Rectangle).
//
// Leaves stand one after the other without padding between them, so a kernel that loads whole
// vectors reads past a leaf's end into the next; kLeafPaddingWords follow the last leaf.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "scene/shapes.h"

namespace dapple {

inline constexpr std::size_t kLeafPaddingWords = 16;
inline constexpr std::size_t kMaxLeafCount = 240;

constexpr std::size_t leaf_words_per_prim(ShapeKind kind) {
  return kind == ShapeKind::sphere ? 5 : 6;
}

// Kind, count and place of a leaf in 64 bits: 4 bits kind, 8 bits count, 52 bits word offset.
// Offset moved on by i and count kept, it denotes primitive i of the leaf: the k-th number of that
// primitive is at word offset + k * count.
struct LeafRef {
  std::uint64_t bits = 0;

  LeafRef() = default;
  constexpr explicit LeafRef(std::uint64_t b) : bits(b) {}
  constexpr LeafRef(ShapeKind kind, std::size_t count, std::size_t offset)
      : bits(static_cast<std::uint64_t>(kind) << 60 | static_cast<std::uint64_t>(count) << 52 |
             offset) {}

  constexpr ShapeKind kind() const { return static_cast<ShapeKind>(bits >> 60); }
  constexpr std::size_t count() const { return (bits >> 52) & 0xff; }
  constexpr std::size_t offset() const { return bits & ((std::uint64_t{1} << 52) - 1); }
  constexpr LeafRef lane(std::size_t i) const { return LeafRef(bits + i); }
};

// The k-th number of primitive `lane` as stored, and as the float it usually is.
inline std::uint32_t leaf_word(const std::uint32_t* words, LeafRef lane, std::size_t k) {
  return words[lane.offset() + k * lane.count()];
}
inline float leaf_float(const std::uint32_t* words, LeafRef lane, std::size_t k) {
  return std::bit_cast<float>(leaf_word(words, lane, k));
}
inline std::uint32_t leaf_prim_id(const std::uint32_t* words, LeafRef lane) {
  return leaf_word(words, lane, leaf_words_per_prim(lane.kind()) - 1);
}

}  // namespace dapple
