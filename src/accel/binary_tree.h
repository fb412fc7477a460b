// A binary tree over a small range, and its best reading as a tree of wide nodes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "accel/range_splitter.h"
#include "scene/wide_bvh.h"

namespace dapple {

// Each wide node is a cut through the subtree of one binary node: at most kWideWidth nodes that
// cover all its leaves. The cuts that make the expected number of visited nodes and leaves least
// are found from the leaves up by dynamic programming over the number of slots a subtree may use
// [YlitieKL17].
class BinaryTree {
 public:
  BinaryTree(RangeSplitter& splitter, const PrimRange& range, BvhQuality quality);

  using NodeId = std::uint32_t;
  static constexpr NodeId kRoot = 0;

  const PrimRange& range(NodeId node) const { return nodes_[node].range; }
  bool is_leaf(NodeId node) const { return nodes_[node].right == 0; }
  // How many nodes and leaves rays are expected to visit, times half the surface area they enter.
  float cost() const { return nodes_[kRoot].cost[1]; }

  std::size_t leaf_count() const { return (nodes_.size() + 1) / 2; }

  // The children of the wide node that stands for an inner node, left to right.
  struct Cut {
    std::array<NodeId, kWideWidth> nodes;
    std::size_t count = 0;
  };
  Cut children(NodeId node) const;

 private:
  struct Node {
    PrimRange range;                           // of an inner node only the boxes count
    NodeId left = 0, right = 0;                // 0 for a leaf
    std::array<float, kWideWidth + 1> cost{};  // least cost with at most i slots
    std::array<std::uint8_t, kWideWidth + 1>
        slots_left{};              // slots of the left child then; 0: one node
    std::uint8_t left_of_all = 0;  // slots of the left child when this is a wide node itself
  };

  void grow(RangeSplitter& splitter, const PrimRange& range, int depth);
  void choose_all_cuts(NodeId node);
  void choose_cuts(NodeId node);
  void collect(NodeId node, std::size_t slots, Cut& cut) const;

  std::vector<Node> nodes_;
};

}  // namespace dapple
