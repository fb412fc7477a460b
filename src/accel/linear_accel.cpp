#include "accel/linear_accel.h"

#include "accel/kernels/dispatch.h"
#include "scene/prims.h"
#include "util/float_mode.h"

namespace dapple {

LinearAccel::LinearAccel(const SceneView& scene)
    : list_(scene), bounds_(scene_bounds(scene)), prim_count_(scene.object_count()) {
  set_leaf_rows(list_.rows());
}

void LinearAccel::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  const StandardFloatMode standard;
  kernels().intersect_linear({list_.leaves(), list_.rows()}, rays.data(), hits.data(), rays.size());
}

void LinearAccel::occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  const StandardFloatMode standard;
  kernels().occluded_linear({list_.leaves(), list_.rows()}, rays.data(), occluded.data(),
                            rays.size());
}

AccelStats LinearAccel::stats() const {
  AccelStats stats;
  stats.prim_count = prim_count_;
  stats.leaf_count = list_.leaves().size();
  stats.bytes = list_.bytes();
  return stats;
}

}  // namespace dapple
