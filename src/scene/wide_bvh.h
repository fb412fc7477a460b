// The finished BVH as plain data: what kernels traverse and what a scene file may hold.
//
// Nodes stand in depth-first order: node 0 is the root, and the first inner child of a node is
// the next node. Leaves stand in the order in which that walk meets them and tile the words
// exactly, so one linear pass proves a tree whole.
#pragma once

#include <cstdint>
#include <span>

#include "math/bounds3.h"
#include "scene/leaf.h"

namespace dapple {

inline constexpr int kWideWidth = 16;
inline constexpr std::size_t kMaxWideLeafCount = 16;
// Levels of nodes at most; the traversal's stacks are made for it.
inline constexpr int kMaxWideDepth = 48;

// A child of a wide node in 64 bits: a LeafRef, or with all four kind bits set the index of a
// node, or with all bits set nothing.
struct ChildRef {
  std::uint64_t bits = ~std::uint64_t{0};

  static constexpr std::uint64_t kNodeTag = std::uint64_t{15} << 60;

  constexpr ChildRef() = default;
  constexpr explicit ChildRef(std::uint64_t b) : bits(b) {}
  constexpr explicit ChildRef(LeafRef leaf) : bits(leaf.bits) {}
  static constexpr ChildRef node(std::uint64_t index) { return ChildRef(kNodeTag | index); }

  constexpr bool empty() const { return bits == ~std::uint64_t{0}; }
  constexpr bool is_leaf() const { return bits < kNodeTag; }
  constexpr std::uint64_t node_index() const { return bits & ~kNodeTag; }
  constexpr LeafRef leaf() const { return LeafRef(bits); }
};

// Used children come first; an empty one has the empty box (lo = +inf, hi = -inf).
struct alignas(64) WideNode {
  float lo[3][kWideWidth];
  float hi[3][kWideWidth];
  ChildRef children[kWideWidth];
};
static_assert(sizeof(WideNode) == 512);

// An empty scene has no nodes. Words end with kLeafPaddingWords zeros.
struct WideBvhView {
  std::span<const WideNode> nodes;
  std::span<const std::uint32_t> leaf_words;

  bool empty() const { return nodes.empty(); }
};

}  // namespace dapple
