#include "accel/wide_accel.h"

#include "accel/kernels/dispatch.h"
#include "accel/wide_stats.h"
#include "util/float_mode.h"

namespace dapple {

WideAccel::WideAccel(const SceneView& scene) : view_(scene.bvh), prim_count_(scene.object_count()) {
  if (view_.empty()) {
    built_ = build_wide_bvh(scene);
    view_ = built_.view();
  }
  set_leaf_rows(view_.rows.data());
}

void WideAccel::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  const StandardFloatMode standard;
  kernels().intersect_wide(view_, rays.data(), hits.data(), rays.size());
}

void WideAccel::occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  const StandardFloatMode standard;
  kernels().occluded_wide(view_, rays.data(), occluded.data(), rays.size());
}

AccelStats WideAccel::stats() const {
  AccelStats stats = wide_stats(view_);
  stats.prim_count = prim_count_;
  return stats;
}

Bounds3f WideAccel::bounds() const {
  return view_.empty() ? Bounds3f{} : node_bounds(view_.nodes.front());
}

}  // namespace dapple
