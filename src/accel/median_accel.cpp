#include "accel/median_accel.h"

#include <algorithm>

#include "accel/intersect_scalar.h"
#include "parallel/tasks.h"
#include "util/float_mode.h"

namespace dapple {
namespace {

constexpr std::size_t kTaskPrims = 1024;

}  // namespace

MedianAccel::MedianAccel(const SceneView& scene)
    : list_(scene), prim_count_(scene.object_count()), leaf_count_(prim_count_) {
  const auto node_count = [](std::size_t prims) { return prims == 0 ? 0 : 2 * prims - 1; };
  std::size_t nodes = node_count(prim_count_);
  std::vector<std::uint32_t> contents;
  for (const Prototype& prototype : scene.prototypes) {
    const bool empty = prototype.triangle_count == 0;
    contents.push_back(empty ? PlacedInstance::kNothing : static_cast<std::uint32_t>(nodes));
    nodes += node_count(prototype.triangle_count);
    leaf_count_ += prototype.triangle_count;
  }
  nodes_.resize(nodes);
  instances_ = place_instances(scene, contents);
  first_instance_ =
      static_cast<PrimId>(first_prim_ids(scene)[static_cast<std::size_t>(ShapeKind::instance)]);
  set_leaves({list_.rows()}, instances_);
  run_with_tasks(leaf_count_, [&] {
    HugeArray<BuildPrim> prims = make_build_prims(scene, prototype_boxes(scene));
    if (prim_count_ > 0) build(prims.span(), 0, 0);
    for (std::size_t i = 0; i < contents.size(); ++i) {
      if (contents[i] == PlacedInstance::kNothing) continue;
      HugeArray<BuildPrim> triangles = make_prototype_prims(scene, scene.prototypes[i]);
      build(triangles.span(), 0, contents[i]);
    }
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
  if (lane.kind() == ShapeKind::instance) return visit_instance(ray, lane, best);
  const float t = intersect_lane(ray, list_.rows(), lane, best.t);
  if (t < 0.0f) return;
  const Hit hit{t, node.prim, lane};
  if (t < best.t || precedes(hit, best)) best = hit;
}

void MedianAccel::visit_instance(const PreparedRay& ray, LeafRef lane, Hit& best) const {
  float box[6];
  for (std::size_t i = 0; i < 6; ++i) box[i] = leaf_float(list_.rows(), lane, i);
  const float entry = enter_instance_box(ray, box, best.t);
  const std::size_t index = leaf_prim_id(list_.rows(), lane) - first_instance_;
  if (entry < 0.0f || instances_[index].content == PlacedInstance::kNothing) return;
  const PreparedRay within = enter_instance(instances_[index], ray);
  Hit inside{smaller(within.t_max, best.t), kNoPrim, {}};
  visit(within, instances_[index].content, inside);
  keep_seen_through(index, entry, inside, best);
}

bool MedianAccel::instance_occludes(const PreparedRay& ray, LeafRef lane) const {
  Hit best{ray.t_max, kNoPrim, {}};
  visit_instance(ray, lane, best);
  return best.found();
}

bool MedianAccel::occludes(const PreparedRay& ray, std::size_t index) const {
  const Node& node = nodes_[index];
  const Slab inside = padded_interval(ray, &node.box.lo.x, &node.box.hi.x);
  if (!(inside.near <= smaller(inside.far, ray.t_max))) return false;
  if (!node.is_leaf()) return occludes(ray, index + 1) || occludes(ray, node.second);
  const LeafRef lane = list_.lane_of(node.prim);
  if (lane.kind() == ShapeKind::instance) return instance_occludes(ray, lane);
  return intersect_lane(ray, list_.rows(), lane, ray.t_max) >= 0.0f;
}

void MedianAccel::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  const StandardFloatMode standard;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const PreparedRay ray = prepare(rays[i]);
    Hit best{ray.t_max, kNoPrim, {}};
    if (prim_count_ > 0) visit(ray, 0, best);
    hits[i] = best.found() ? best : Hit{};
  }
}

void MedianAccel::occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  const StandardFloatMode standard;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    occluded[i] = prim_count_ > 0 && occludes(prepare(rays[i]), 0) ? 1 : 0;
  }
}

AccelStats MedianAccel::stats() const {
  AccelStats stats;
  stats.prim_count = prim_count_;
  stats.leaf_count = leaf_count_;
  stats.node_count = nodes_.size() - leaf_count_;
  stats.bytes =
      nodes_.size() * sizeof(Node) + list_.bytes() + instances_.size() * sizeof(PlacedInstance);
  if (prim_count_ == 0) return stats;
  double visits = 0;
  for (const Node& node : std::span(nodes_).first(2 * prim_count_ - 1)) {
    visits += double{node.box.half_area()};
  }
  const double root_area = double{nodes_[0].box.half_area()};
  stats.sah_cost = root_area > 0 ? visits / root_area : 0;
  for (std::size_t n = prim_count_; n > 1; n = (n + 1) / 2) ++stats.depth;
  return stats;
}

Bounds3f MedianAccel::bounds() const { return prim_count_ == 0 ? Bounds3f{} : nodes_[0].box; }

}  // namespace dapple
