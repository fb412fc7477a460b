#include "accel/binary_tree.h"

#include <limits>

namespace dapple {
namespace {

// From this depth on ranges are split in half: a subtree is at most 2^13 primitives, ten levels.
constexpr int kHalvingDepth = 16;

}  // namespace

BinaryTree::BinaryTree(RangeSplitter& splitter, const PrimRange& range) {
  nodes_.reserve(range.size() / 4 + 1);
  grow(splitter, range, 0);
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
  grow(splitter, left, depth + 1);
  nodes_[node].right = static_cast<NodeId>(nodes_.size());
  grow(splitter, right, depth + 1);
  choose_cuts(node);
}

void BinaryTree::choose_cuts(NodeId id) {
  Node& node = nodes_[id];
  const auto& left = nodes_[id + 1].cost;
  const auto& right = nodes_[node.right].cost;
  for (std::size_t slots = 2; slots <= kWideWidth; ++slots) {
    float best = std::numeric_limits<float>::infinity();
    for (std::size_t k = 1; k < slots; ++k) {
      const float cost = left[k] + right[slots - k];
      if (cost < best) {
        best = cost;
        node.left[slots] = static_cast<std::uint8_t>(k);
      }
    }
    node.cost[slots] = best;
  }
  node.left_of_all = node.left[kWideWidth] == 0 ? 1 : node.left[kWideWidth];
  node.cost[1] = node.cost[kWideWidth] + node.range.box.half_area();
  for (std::size_t slots = 2; slots <= kWideWidth; ++slots) {
    if (node.cost[slots] < node.cost[1]) continue;
    node.cost[slots] = node.cost[1];
    node.left[slots] = 0;
  }
}

void BinaryTree::collect(NodeId id, std::size_t slots, Cut& cut) const {
  const Node& node = nodes_[id];
  if (is_leaf(id) || node.left[slots] == 0) {
    cut.nodes[cut.count++] = id;
    return;
  }
  collect(id + 1, node.left[slots], cut);
  collect(node.right, slots - node.left[slots], cut);
}

BinaryTree::Cut BinaryTree::children(NodeId id) const {
  const Node& node = nodes_[id];
  Cut cut;
  collect(id + 1, node.left_of_all, cut);
  collect(node.right, kWideWidth - node.left_of_all, cut);
  return cut;
}

}  // namespace dapple
