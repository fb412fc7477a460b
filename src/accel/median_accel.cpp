#include "accel/median_accel.h"

#include <algorithm>

#include "accel/intersect_scalar.h"
#include "parallel/tasks.h"
#include "util/float_mode.h"

namespace dapple {
namespace {

constexpr std::size_t kTaskPrims = 1024;

}  // namespace

MedianAccel::MedianAccel(const SceneView& scene) : list_(scene), prim_count_(scene.object_count()) {
  set_leaf_rows(list_.rows());
  if (prim_count_ == 0) return;
  nodes_.resize(2 * prim_count_ - 1);
  run_with_tasks(prim_count_, [&] {
    HugeArray<BuildPrim> prims = make_build_prims(scene);
    build(prims.span(), 0, 0);
  });
}

void MedianAccel::build(std::span<BuildPrim> prims, int axis, std::size_t index) {
  Node& node = nodes_[index];
  Box4 box;
  for (const BuildPrim& prim : prims) box.extend(prim);
  node.box = box.bounds();
  if (prims.size() == 1) {
    node.prim = prims[0].id;
    return;
  }
  // Finding the median is all that sorting is for. Equal minima are ordered by id, so that there
  // is one answer.
  const std::size_t half = prims.size() / 2;
  std::nth_element(prims.begin(), prims.begin() + static_cast<std::ptrdiff_t>(half), prims.end(),
                   [axis](const BuildPrim& a, const BuildPrim& b) {
                     return a.lo[axis] != b.lo[axis] ? a.lo[axis] < b.lo[axis] : a.id < b.id;
                   });
  const std::size_t second = index + 2 * half;
  node.second = static_cast<std::uint32_t>(second);
  const int next_axis = (axis + 1) % 3;
  TaskGroup tasks;
  const auto first_half = [=, this] { build(prims.first(half), next_axis, index + 1); };
  if (prims.size() > kTaskPrims) {
    tasks.run(first_half);
  } else {
    first_half();
  }
  build(prims.subspan(half), next_axis, second);
  tasks.wait();
}

void MedianAccel::visit(const PreparedRay& ray, std::size_t index, Hit& best) const {
  const Node& node = nodes_[index];
  const Slab inside = padded_interval(ray, &node.box.lo.x, &node.box.hi.x);
  if (!(inside.near <= smaller(inside.far, best.t))) return;
  if (!node.is_leaf()) {
    visit(ray, index + 1, best);
    visit(ray, node.second, best);
    return;
  }
  const LeafRef lane = list_.lane_of(node.prim);
  const float t = intersect_lane(ray, list_.rows(), lane, best.t);
  if (t < 0.0f) return;
  if (t < best.t || node.prim < best.prim) best = {t, node.prim, lane};
}

bool MedianAccel::occludes(const PreparedRay& ray, std::size_t index) const {
  const Node& node = nodes_[index];
  const Slab inside = padded_interval(ray, &node.box.lo.x, &node.box.hi.x);
  if (!(inside.near <= smaller(inside.far, ray.t_max))) return false;
  if (!node.is_leaf()) return occludes(ray, index + 1) || occludes(ray, node.second);
  return intersect_lane(ray, list_.rows(), list_.lane_of(node.prim), ray.t_max) >= 0.0f;
}

void MedianAccel::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  const StandardFloatMode standard;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const PreparedRay ray = prepare(rays[i]);
    Hit best{ray.t_max, kNoPrim, {}};
    if (!nodes_.empty()) visit(ray, 0, best);
    hits[i] = best.found() ? best : Hit{};
  }
}

void MedianAccel::occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  const StandardFloatMode standard;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    occluded[i] = !nodes_.empty() && occludes(prepare(rays[i]), 0) ? 1 : 0;
  }
}

AccelStats MedianAccel::stats() const {
  AccelStats stats;
  stats.prim_count = prim_count_;
  stats.leaf_count = prim_count_;
  stats.node_count = nodes_.size() - prim_count_;
  stats.bytes = nodes_.size() * sizeof(Node) + list_.bytes();
  if (nodes_.empty()) return stats;
  double visits = 0;
  for (const Node& node : nodes_) visits += double{node.box.half_area()};
  const double root_area = double{nodes_[0].box.half_area()};
  stats.sah_cost = root_area > 0 ? visits / root_area : 0;
  for (std::size_t n = prim_count_; n > 1; n = (n + 1) / 2) ++stats.depth;
  return stats;
}

Bounds3f MedianAccel::bounds() const { return nodes_.empty() ? Bounds3f{} : nodes_[0].box; }

}  // namespace dapple
