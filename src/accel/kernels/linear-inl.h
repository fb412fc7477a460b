// Brute force: each ray against every leaf.
#include "accel/kernels/dispatch.h"
#include "accel/kernels/leaf-inl.h"

#if defined(DAPPLE_KERNELS_LINEAR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_LINEAR_INL_H
#undef DAPPLE_KERNELS_LINEAR_INL_H
#else
#define DAPPLE_KERNELS_LINEAR_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

HWY_ATTR void intersect_linear(const LinearView& view, const Ray* rays, Hit* hits,
                               std::size_t count) {
  for (std::size_t r = 0; r < count; ++r) {
    const PreparedRay ray = prepare(rays[r]);
    Hit best = nothing_before(ray.t_max);
    for (std::size_t i = 0; i < view.leaves.size(); ++i) {
      intersect_leaf(ray, view.leaves[i], view.rows, best);
    }
    hits[r] = finished(best);
  }
}

HWY_ATTR void occluded_linear(const LinearView& view, const Ray* rays, std::uint8_t* occluded,
                              std::size_t count) {
  for (std::size_t r = 0; r < count; ++r) {
    const PreparedRay ray = prepare(rays[r]);
    occluded[r] = 0;
    for (std::size_t i = 0; i < view.leaves.size() && occluded[r] == 0; ++i) {
      occluded[r] = leaf_occludes(ray, view.leaves[i], view.rows) ? 1 : 0;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
