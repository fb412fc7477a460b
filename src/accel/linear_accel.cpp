#include "accel/linear_accel.h"

#include "accel/kernels/dispatch.h"
#include "scene/prims.h"
#include "util/float_mode.h"

namespace dapple {

LinearAccel::LinearAccel(const SceneView& scene)
    : list_(scene), bounds_(scene_bounds(scene)), prim_count_(scene.object_count()) {
  std::vector<std::uint32_t> contents;
  for (std::size_t i = 0; i < scene.prototypes.size(); ++i) {
    contents.push_back(static_cast<std::uint32_t>(i));
    prototypes_.push_back(list_.leaves_of_prototype(i));
  }
  instances_ = place_instances(scene, contents);
  view_.instances = instances_;
  view_.first_id =
      static_cast<PrimId>(first_prim_ids(scene)[static_cast<std::size_t>(ShapeKind::instance)]);
  view_.kinds = leaf_kinds(scene);
  view_.leaves = list_.leaves();
  view_.prototypes = prototypes_;
  view_.rows = list_.rows();
  set_leaves({list_.rows()}, instances_);
}

void LinearAccel::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  const StandardFloatMode standard;
  kernels().intersect_linear(view_, rays.data(), hits.data(), rays.size());
}

void LinearAccel::occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  const StandardFloatMode standard;
  kernels().occluded_linear(view_, rays.data(), occluded.data(), rays.size());
}

AccelStats LinearAccel::stats() const {
  AccelStats stats;
  stats.prim_count = prim_count_;
  stats.leaf_count = list_.leaves().size();
  stats.bytes = list_.bytes() + instances_.size() * sizeof(PlacedInstance);
  return stats;
}

}  // namespace dapple
