#include "report/visiting_accel.h"

#include <algorithm>

#include "accel/intersect_scalar.h"

namespace dapple::bench {
namespace {

struct Waiting {
  ChildRef child;
  float near;
};

}  // namespace

void VisitingAccel::visit_node(std::size_t index) const {
  ++counts_.nodes;
  counts_.bytes += sizeof(WideNode);
  if (!seen_nodes_[index]) counts_.distinct_bytes += sizeof(WideNode);
  seen_nodes_[index] = true;
}

float VisitingAccel::visit_leaf(const PreparedRay& ray, LeafRef leaf, float best) const {
  const std::size_t bytes = dapple::leaf_rows(leaf.kind()) * sizeof(LeafRow);
  ++counts_.leaves;
  counts_.bytes += bytes;
  if (!seen_rows_[leaf.first_row()]) counts_.distinct_bytes += bytes;
  seen_rows_[leaf.first_row()] = true;
  for (std::size_t i = 0; i < kLeafWidth; ++i) {
    const float t = intersect_lane(ray, tree_.rows.data(), leaf.lane(i), best);
    if (t >= 0 && t < best) best = t;
  }
  return best;
}

void VisitingAccel::walk(const PreparedRay& ray) const {
  ++counts_.rays;
  if (tree_.empty() || ray.t_max < 0) return;
  float best = ray.t_max;
  std::vector<Waiting> stack = {{ChildRef::node(0), 0}};
  while (!stack.empty()) {
    const Waiting next = stack.back();
    stack.pop_back();
    if (next.near > best) continue;
    if (next.child.is_leaf()) {
      best = visit_leaf(ray, next.child.leaf_ref(), best);
      continue;
    }
    visit_node(next.child.node_index());
    const WideNode& node = tree_.nodes[next.child.node_index()];
    const std::size_t first = stack.size();
    for (std::size_t i = 0; i < kWideWidth && !node.children[i].empty(); ++i) {
      const float lo[3] = {node.lo[0][i], node.lo[1][i], node.lo[2][i]};
      const float hi[3] = {node.hi[0][i], node.hi[1][i], node.hi[2][i]};
      const Slab slab = box_interval(ray, lo, hi);
      if (slab.near <= slab.far && slab.near <= best) {
        stack.push_back({node.children[i], slab.near});
      }
    }
    std::sort(stack.begin() + static_cast<std::ptrdiff_t>(first), stack.end(),
              [](const Waiting& a, const Waiting& b) { return a.near > b.near; });
  }
}

}  // namespace dapple::bench
