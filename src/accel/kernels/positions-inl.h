// Points of an array of them, wherever each lane wants its own.
#include "math/simd-inl.h"

#if defined(DAPPLE_KERNELS_POSITIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_POSITIONS_INL_H
#undef DAPPLE_KERNELS_POSITIONS_INL_H
#else
#define DAPPLE_KERNELS_POSITIONS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// What may be read behind a point: four floats are loaded faster than three.
enum class AfterLast { a_float, nothing };

#if HWY_TARGET == HWY_SCALAR

template <AfterLast kAfter>
HWY_INLINE FloatVec3 load_positions(const Vec3f* positions, const std::uint32_t* index) {
  return all(positions[*index]);
}

#else

using PointTag = hn::FixedTag<float, 4>;
using PointVec = hn::Vec<PointTag>;

template <AfterLast kAfter>
HWY_INLINE PointVec load_point(const Vec3f& point) {
  const PointTag d;
  if (kAfter == AfterLast::a_float) return hn::LoadU(d, &point.x);
#if HWY_TARGET <= HWY_AVX2
  return hn::MaskedLoad(hn::FirstN(d, 3), d, &point.x);
#else
  const hn::Half<PointTag> two;
  return hn::Combine(d, hn::Set(two, point.z), hn::LoadU(two, &point.x));
#endif
}

// Points 0, 4, 8 and 12, or as many of them as fill a vector, each in a block of four lanes.
template <AfterLast kAfter>
HWY_INLINE FloatVec load_every_fourth(const Vec3f* positions, const std::uint32_t* index) {
  const auto point = [&](std::size_t i)
                         HWY_ATTR { return load_point<kAfter>(positions[index[i]]); };
#if HWY_TARGET <= HWY_AVX3
  const hn::Half<Floats> half;
  return hn::Combine(Floats(), hn::Combine(half, point(12), point(8)),
                     hn::Combine(half, point(4), point(0)));
#elif HWY_TARGET == HWY_AVX2
  return hn::Combine(Floats(), point(4), point(0));
#else
  return point(0);
#endif
}

// positions[index[i]] in lane i. Loading whole points and turning them takes a third of the loads
// that gathering their coordinates would.
template <AfterLast kAfter>
HWY_INLINE FloatVec3 load_positions(const Vec3f* positions, const std::uint32_t* index) {
  const Floats d;
  const FloatVec a = load_every_fourth<kAfter>(positions, index);
  const FloatVec b = load_every_fourth<kAfter>(positions, index + 1);
  const FloatVec c = load_every_fourth<kAfter>(positions, index + 2);
  const FloatVec e = load_every_fourth<kAfter>(positions, index + 3);
  const FloatVec ac = hn::InterleaveLower(d, a, c), be = hn::InterleaveLower(d, b, e);
  const FloatVec ac_z = hn::InterleaveUpper(d, a, c), be_z = hn::InterleaveUpper(d, b, e);
  return {hn::InterleaveLower(d, ac, be), hn::InterleaveUpper(d, ac, be),
          hn::InterleaveLower(d, ac_z, be_z)};
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
