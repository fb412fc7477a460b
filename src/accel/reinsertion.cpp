#include "accel/reinsertion.h"

#include <algorithm>
#include <utility>

namespace dapple {
namespace {

constexpr int kPasses = 2;

using NodeId = std::uint32_t;

Box4 united(Box4 a, const Box4& b) {
  a.extend(b);
  return a;
}

class Reinserter {
 public:
  explicit Reinserter(TreeShape& tree) : tree_(tree), parents_(tree.size()) {
    for (NodeId i = 0; i < tree.size(); ++i) {
      if (is_leaf(i)) continue;
      parents_[tree[i].left] = parents_[tree[i].right] = i;
    }
  }

  // All subtrees, those with the largest surface first.
  void pass() {
    std::vector<std::pair<float, NodeId>> order;
    for (NodeId i = 1; i < tree_.size(); ++i) order.emplace_back(-tree_[i].box.half_area(), i);
    std::sort(order.begin(), order.end());
    for (const auto& [area, node] : order) {
      if (parents_[node] != 0) move(node);
    }
  }

  int depth() const {
    int deepest = 0;
    std::vector<std::pair<NodeId, int>> stack = {{0, 0}};
    while (!stack.empty()) {
      const auto [node, depth] = stack.back();
      stack.pop_back();
      deepest = std::max(deepest, depth);
      if (is_leaf(node)) continue;
      stack.emplace_back(tree_[node].left, depth + 1);
      stack.emplace_back(tree_[node].right, depth + 1);
    }
    return deepest;
  }

 private:
  bool is_leaf(NodeId node) const { return tree_[node].right == 0; }

  void replace_child(NodeId parent, NodeId child, NodeId by) {
    (tree_[parent].left == child ? tree_[parent].left : tree_[parent].right) = by;
    parents_[by] = parent;
  }

  void refit_from(NodeId node) {
    while (true) {
      tree_[node].box = united(tree_[tree_[node].left].box, tree_[tree_[node].right].box);
      if (node == 0) return;
      node = parents_[node];
    }
  }

  // Takes the subtree out, with its parent, and puts both between another node and its parent.
  void move(NodeId node) {
    const NodeId parent = parents_[node], grandparent = parents_[parent];
    const NodeId sibling = tree_[parent].left == node ? tree_[parent].right : tree_[parent].left;
    replace_child(grandparent, parent, sibling);
    refit_from(grandparent);
    const NodeId target = find_place(node, sibling);
    replace_child(parents_[target], target, parent);
    tree_[parent].left = target;
    tree_[parent].right = node;
    parents_[target] = parents_[node] = parent;
    refit_from(parent);
  }

  struct Candidate {
    float induced;  // by how much the boxes above grow
    NodeId node;

    // The least first, and the lower id among equals.
    bool operator<(const Candidate& other) const {
      return induced != other.induced ? induced > other.induced : node > other.node;
    }
  };

  // Best first: nothing below a node costs less than the growth above it and the subtree itself.
  // Where nothing is better, it goes back to its sibling.
  NodeId find_place(NodeId node, NodeId sibling) {
    const Box4& box = tree_[node].box;
    const float least = box.half_area();
    float best = cost_beside(node, sibling);
    NodeId place = sibling;
    queue_.clear();
    // Not at the root itself, which stays the first node.
    push_children(0, united(tree_[0].box, box).half_area() - tree_[0].box.half_area());
    while (!queue_.empty()) {
      std::pop_heap(queue_.begin(), queue_.end());
      const Candidate candidate = queue_.back();
      queue_.pop_back();
      if (!(candidate.induced + least < best)) break;
      const float whole = united(tree_[candidate.node].box, box).half_area();
      if (candidate.induced + whole < best) {
        best = candidate.induced + whole;
        place = candidate.node;
      }
      const float grown = candidate.induced + (whole - tree_[candidate.node].box.half_area());
      if (!is_leaf(candidate.node) && grown + least < best) push_children(candidate.node, grown);
    }
    return place;
  }

  void push_children(NodeId node, float induced) {
    for (const NodeId child : {tree_[node].left, tree_[node].right}) {
      queue_.push_back({induced, child});
      std::push_heap(queue_.begin(), queue_.end());
    }
  }

  float cost_beside(NodeId node, NodeId place) const {
    const Box4& box = tree_[node].box;
    float cost = united(tree_[place].box, box).half_area();
    for (NodeId above = place; above != 0;) {
      above = parents_[above];
      cost += united(tree_[above].box, box).half_area() - tree_[above].box.half_area();
    }
    return cost;
  }

  TreeShape& tree_;
  std::vector<NodeId> parents_;
  std::vector<Candidate> queue_;
};

}  // namespace

bool reinsert_subtrees(TreeShape& tree, int max_depth) {
  if (tree.size() < 5) return true;
  Reinserter reinserter(tree);
  for (int i = 0; i < kPasses; ++i) reinserter.pass();
  return reinserter.depth() <= max_depth;
}

}  // namespace dapple
