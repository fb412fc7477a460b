// The finished BVH as plain data: what kernels traverse and what a scene file may hold.
//
// Nodes stand in depth-first order: node 0 is the root, and the first inner child of a node is
// the next node. The tree of what stands in the world comes first, then that of each prototype, in
// their order; none for what is empty. Leaves stand in the order of the nodes they hang from, and
// under one node in the order of its children; they tile the rows exactly. So one linear pass over
// the nodes proves a tree whole.
#pragma once

#include <cstdint>
#include <span>

#include "math/bounds3.h"
#include "scene/leaf.h"

namespace dapple {

inline constexpr int kWideWidth = 16;
// Levels of nodes at most; the traversal's stacks are made for it.
inline constexpr int kMaxWideDepth = 48;

// A child of a wide node in 32 bits: the index of a node below 2^31 - 1; or a leaf, with the
// highest bit set, three bits for its kind and 28 for its first row; or kEmpty.
struct ChildRef {
  std::uint32_t bits = kEmpty;

  static constexpr std::uint32_t kEmpty = 0xffffffffu;
  static constexpr std::uint32_t kLeafTag = 0x80000000u;
  static constexpr std::uint64_t kMaxRow = (std::uint64_t{1} << 28) - 1;  // 16 GiB of leaves

  constexpr ChildRef() = default;
  constexpr explicit ChildRef(std::uint32_t b) : bits(b) {}
  static constexpr ChildRef node(std::size_t index) {
    return ChildRef(static_cast<std::uint32_t>(index));
  }
  static constexpr ChildRef leaf(ShapeKind kind, std::size_t first_row) {
    return ChildRef(kLeafTag | static_cast<std::uint32_t>(kind) << 28 |
                    static_cast<std::uint32_t>(first_row));
  }

  constexpr bool empty() const { return bits == kEmpty; }
  constexpr bool is_leaf() const { return bits >= kLeafTag && bits != kEmpty; }
  constexpr bool is_node() const { return bits < kLeafTag; }
  constexpr std::size_t node_index() const { return bits; }
  constexpr ShapeKind leaf_kind() const { return static_cast<ShapeKind>(bits >> 28 & 7); }
  constexpr std::size_t leaf_row() const { return bits & kMaxRow; }
  constexpr LeafRef leaf_ref() const { return {leaf_kind(), leaf_row()}; }
};

// Used children come first; an empty one has the empty box (lo = +inf, hi = -inf).
struct alignas(64) WideNode {
  float lo[3][kWideWidth];
  float hi[3][kWideWidth];
  ChildRef children[kWideWidth];
};
static_assert(sizeof(WideNode) == 448);

// An empty scene has no nodes and no rows.
struct WideBvhView {
  std::span<const WideNode> nodes;
  std::span<const LeafRow> rows;
  LeafForm form = LeafForm::whole;

  bool empty() const { return nodes.empty(); }
};

}  // namespace dapple
