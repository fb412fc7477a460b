#include "accel/wide_stats.h"

#include <algorithm>
#include <vector>

#include "accel/wide_builder.h"

namespace dapple {
namespace {

Bounds3f child_bounds(const WideNode& node, std::size_t i) {
  return {{node.lo[0][i], node.lo[1][i], node.lo[2][i]},
          {node.hi[0][i], node.hi[1][i], node.hi[2][i]}};
}

}  // namespace

Bounds3f node_bounds(const WideNode& node) {
  Bounds3f box;
  for (std::size_t i = 0; i < kWideWidth; ++i) {
    if (!node.children[i].empty()) box.extend(child_bounds(node, i));
  }
  return box;
}

AccelStats wide_stats(const WideBvhView& bvh) {
  AccelStats stats;
  stats.node_count = bvh.nodes.size();
  stats.bytes = bvh.nodes.size_bytes() + bvh.rows.size_bytes();
  if (bvh.empty()) return stats;
  const double root_area = double{node_bounds(bvh.nodes[0]).half_area()};
  double visits = root_area;
  std::vector<int> depth(bvh.nodes.size(), 1);
  const std::vector<std::uint32_t> roots = tree_roots(bvh.nodes);
  const std::size_t world_end = roots.size() > 1 ? roots[1] : bvh.nodes.size();
  for (std::size_t n = 0; n < bvh.nodes.size(); ++n) {
    const WideNode& node = bvh.nodes[n];
    stats.depth = std::max(stats.depth, depth[n]);
    for (std::size_t i = 0; i < kWideWidth; ++i) {
      const ChildRef child = node.children[i];
      if (child.empty()) continue;
      if (n < world_end) visits += double{child_bounds(node, i).half_area()};
      if (child.is_leaf()) {
        ++stats.leaf_count;
      } else {
        depth[child.node_index()] = depth[n] + 1;  // children stand after their parents
      }
    }
  }
  stats.sah_cost = root_area > 0 ? visits / root_area : 0;
  return stats;
}

}  // namespace dapple
