#include "accel/binary_tree.h"

#include <limits>

#include "accel/reinsertion.h"

namespace dapple {
namespace {

// From this depth on ranges are split in half: a subtree is at most 2^15 primitives and as many
// parts of triangles, twelve levels.
constexpr int kHalvingDepth = 16;
// What that makes of the deepest tree, with kinds that are told apart in its leaves. Reinsertion
// may not go beyond it.
constexpr int kMaxDepth = kHalvingDepth + 18;

}  // namespace

BinaryTree::BinaryTree(RangeSplitter& splitter, const PrimRange& range, BvhQuality quality) {
  nodes_.reserve(range.size() / 4 + 1);
  grow(splitter, range, 0);
  if (quality == BvhQuality::high) {
    TreeShape shape(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      shape[i] = {nodes_[i].range.box, nodes_[i].left, nodes_[i].right};
    }
    if (reinsert_subtrees(shape, kMaxDepth)) {
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        nodes_[i].range.box = shape[i].box;
        nodes_[i].left = shape[i].left;
        nodes_[i].right = shape[i].right;
      }
    }
  }
  choose_all_cuts(kRoot);
}

void BinaryTree::grow(RangeSplitter& splitter, const PrimRange& range, int depth) {
  const auto node = static_cast<NodeId>(nodes_.size());
  nodes_.emplace_back().range = range;
  if (splitter.is_leaf(range)) {
    nodes_[node].cost.fill(range.box.half_area());
    return;
  }
  const auto [left, right] =
      splitter.split(range, depth < kHalvingDepth ? SplitBy::sah : SplitBy::number);
  nodes_[node].left = static_cast<NodeId>(nodes_.size());
  grow(splitter, left, depth + 1);
  nodes_[node].right = static_cast<NodeId>(nodes_.size());
  grow(splitter, right, depth + 1);
}

void BinaryTree::choose_all_cuts(NodeId node) {
  if (is_leaf(node)) return;
  choose_all_cuts(nodes_[node].left);
  choose_all_cuts(nodes_[node].right);
  choose_cuts(node);
}

void BinaryTree::choose_cuts(NodeId id) {
  Node& node = nodes_[id];
  const auto& left = nodes_[node.left].cost;
  const auto& right = nodes_[node.right].cost;
  for (std::size_t slots = 2; slots <= kWideWidth; ++slots) {
    float best = std::numeric_limits<float>::infinity();
    for (std::size_t k = 1; k < slots; ++k) {
      const float cost = left[k] + right[slots - k];
      if (cost < best) {
        best = cost;
        node.slots_left[slots] = static_cast<std::uint8_t>(k);
      }
    }
    node.cost[slots] = best;
  }
  node.left_of_all = node.slots_left[kWideWidth] == 0 ? 1 : node.slots_left[kWideWidth];
  node.cost[1] = node.cost[kWideWidth] + node.range.box.half_area();
  for (std::size_t slots = 2; slots <= kWideWidth; ++slots) {
    if (node.cost[slots] < node.cost[1]) continue;
    node.cost[slots] = node.cost[1];
    node.slots_left[slots] = 0;
  }
}

void BinaryTree::collect(NodeId id, std::size_t slots, Cut& cut) const {
  const Node& node = nodes_[id];
  if (is_leaf(id) || node.slots_left[slots] == 0) {
    cut.nodes[cut.count++] = id;
    return;
  }
  collect(node.left, node.slots_left[slots], cut);
  collect(node.right, slots - node.slots_left[slots], cut);
}

BinaryTree::Cut BinaryTree::children(NodeId id) const {
  const Node& node = nodes_[id];
  Cut cut;
  collect(node.left, node.left_of_all, cut);
  collect(node.right, kWideWidth - node.left_of_all, cut);
  return cut;
}

}  // namespace dapple
