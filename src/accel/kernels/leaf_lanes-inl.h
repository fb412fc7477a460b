// Rows of leaves as vectors, and what is found of their lanes.
#include "accel/kernels/simd-inl.h"
#include "scene/leaf.h"

#if defined(DAPPLE_KERNELS_LEAF_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_LEAF_LANES_INL_H
#undef DAPPLE_KERNELS_LEAF_LANES_INL_H
#else
#define DAPPLE_KERNELS_LEAF_LANES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Lanes that were hit, and where.
struct LaneHits {
  FloatMask mask;
  FloatVec t;
};

HWY_INLINE FloatVec load_row(const LeafRow* rows, std::size_t row, std::size_t i) {
  return load_floats(reinterpret_cast<const float*>(rows[row].words + i));
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
