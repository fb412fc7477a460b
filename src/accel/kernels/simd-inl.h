// Rays on the vectors of math/simd-inl.h.
#include "accel/prepared_ray.h"
#include "math/simd-inl.h"

#if defined(DAPPLE_KERNELS_SIMD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_SIMD_INL_H
#undef DAPPLE_KERNELS_SIMD_INL_H
#else
#define DAPPLE_KERNELS_SIMD_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

HWY_INLINE float load_float(const std::uint32_t* word) {
  float value;
  __builtin_memcpy(&value, word, sizeof value);
  return value;
}

// Removes the lowest set bit and returns its index.
HWY_INLINE std::uint32_t take_lowest(std::uint32_t& bits) {
  const auto index = static_cast<std::uint32_t>(__builtin_ctz(bits));
  bits &= bits - 1;
  return index;
}

// (plane - origin) * inverse for one axis: where the ray meets the planes.
HWY_INLINE FloatVec meet(FloatVec planes, const PreparedRay& ray, int axis) {
  return hn::Mul(hn::Sub(planes, all(ray.origin[axis])), all(ray.inverse[axis]));
}

// The same where boxes are left.
HWY_INLINE FloatVec meet_far(FloatVec planes, const PreparedRay& ray, int axis) {
  return hn::Mul(hn::Sub(planes, all(ray.origin[axis])), all(ray.inverse_far[axis]));
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
