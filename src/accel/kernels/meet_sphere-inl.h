// intersect_spheres with another ray in each lane.
#include "accel/kernels/leaf_lanes-inl.h"
#include "accel/kernels/prepare-inl.h"

#if defined(DAPPLE_KERNELS_MEET_SPHERE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_MEET_SPHERE_INL_H
#undef DAPPLE_KERNELS_MEET_SPHERE_INL_H
#else
#define DAPPLE_KERNELS_MEET_SPHERE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct SphereLanes {
  FloatVec c[3], radius, lo[3], hi[3];
};

// Where rays meet spheres, not beyond t_max. kOftenNone: in most calls no ray does.
template <bool kOftenNone>
HWY_INLINE LaneHits meet_spheres(const RayLanes& rays, const SphereLanes& spheres) {
  const Floats d;
  const FloatVec *o = rays.origin, *dir = rays.direction;
  FloatVec from[3];
  for (std::size_t axis = 0; axis < 3; ++axis) from[axis] = hn::Sub(o[axis], spheres.c[axis]);
  const FloatVec along = hn::Add(hn::Add(hn::Mul(from[0], dir[0]), hn::Mul(from[1], dir[1])),
                                 hn::Mul(from[2], dir[2]));
  const FloatVec t_mid = hn::Neg(hn::Mul(along, rays.inverse_dot));
  const FloatVec px = hn::Add(from[0], hn::Mul(t_mid, dir[0]));
  const FloatVec py = hn::Add(from[1], hn::Mul(t_mid, dir[1]));
  const FloatVec pz = hn::Add(from[2], hn::Mul(t_mid, dir[2]));
  const FloatVec squared = hn::Add(hn::Add(hn::Mul(px, px), hn::Mul(py, py)), hn::Mul(pz, pz));
  const FloatVec discriminant = hn::Sub(hn::Mul(spheres.radius, spheres.radius), squared);
  FloatMask mask = hn::Gt(discriminant, hn::Zero(d));
  if (kOftenNone && hn::AllFalse(d, mask)) return {mask, t_mid};
  const FloatVec half_chord = hn::Sqrt(hn::Mul(discriminant, rays.inverse_dot));
  const FloatVec first = hn::Sub(t_mid, half_chord);
  const FloatVec raw = hn::IfThenElse(hn::Ge(first, rays.t_min), first, hn::Add(t_mid, half_chord));
  mask = hn::And(mask, hn::And(hn::Ge(raw, rays.t_min), hn::Le(raw, rays.t_max)));
  FloatVec near = rays.t_min, far = all(Bounds3f::kInfinity);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const FloatVec to_lo = hn::Mul(hn::Sub(spheres.lo[axis], o[axis]), rays.inverse[axis]);
    const FloatVec to_hi = hn::Mul(hn::Sub(spheres.hi[axis], o[axis]), rays.inverse[axis]);
    near = hn::Max(hn::Min(to_lo, to_hi), near);
    far = hn::Min(hn::Max(to_lo, to_hi), far);
  }
  const FloatVec t = hn::Max(raw, near);
  return {hn::And(mask, hn::And(hn::Le(near, far), hn::Le(t, rays.t_max))), t};
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
