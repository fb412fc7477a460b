// Leaves of spheres: first which of them a ray's line passes, then where the ray meets those.
#include "accel/kernels/leaf_lanes-inl.h"

#if defined(DAPPLE_KERNELS_LEAF_SPHERES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_LEAF_SPHERES_INL_H
#undef DAPPLE_KERNELS_LEAF_SPHERES_INL_H
#else
#define DAPPLE_KERNELS_LEAF_SPHERES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Where the ray enters and leaves the extent of spheres along one axis.
struct SphereSlab {
  FloatVec near, far;
};

HWY_INLINE SphereSlab slab_of_spheres(const PreparedRay& ray, FloatVec centre, FloatVec size,
                                      int axis) {
  const FloatVec sign = hn::And(all(ray.inverse[axis]), hn::SignBit(Floats()));
  const FloatVec to_far = hn::Or(size, sign);  // `size` has no sign
  return {meet(hn::Sub(centre, to_far), ray, axis), meet(hn::Add(centre, to_far), ray, axis)};
}

// The own-box rule for the spheres that passed so far.
HWY_INLINE LaneHits enter_sphere_boxes(const PreparedRay& ray, FloatVec cx, FloatVec cy,
                                       FloatVec cz, FloatVec radius, LaneHits hits,
                                       FloatVec t_max) {
  const FloatVec size = hn::Abs(radius);
  const SphereSlab x = slab_of_spheres(ray, cx, size, 0);
  const SphereSlab y = slab_of_spheres(ray, cy, size, 1);
  const SphereSlab z = slab_of_spheres(ray, cz, size, 2);
  const FloatVec near = hn::Max(hn::Max(x.near, y.near), hn::Max(z.near, all(ray.t_min)));
  const FloatVec far = hn::Min(hn::Min(x.far, y.far), z.far);
  const FloatVec t = hn::Max(hits.t, near);
  const FloatMask inside = hn::And(hn::Le(near, far), hn::Le(t, t_max));
  return {hn::And(hits.mask, inside), t};
}

// Spheres of which the ray's line passes those of the mask: where it is nearest to their centres,
// and the square of half the chord that they cut from it.
struct PassedSpheres {
  FloatMask mask;
  FloatVec t_mid, discriminant;
};

// Spheres [i, i + kLanes) of a leaf.
HWY_INLINE PassedSpheres pass_spheres(const PreparedRay& ray, const LeafRow* leaf, std::size_t i) {
  const FloatVec radius = load_row(leaf, 3, i);
  const FloatVec ox = hn::Sub(all(ray.origin[0]), load_row(leaf, 0, i));
  const FloatVec oy = hn::Sub(all(ray.origin[1]), load_row(leaf, 1, i));
  const FloatVec oz = hn::Sub(all(ray.origin[2]), load_row(leaf, 2, i));
  const FloatVec dx = all(ray.direction[0]), dy = all(ray.direction[1]), dz = all(ray.direction[2]);
  const FloatVec along = hn::Add(hn::Add(hn::Mul(ox, dx), hn::Mul(oy, dy)), hn::Mul(oz, dz));
  const FloatVec t_mid = hn::Neg(hn::Mul(along, all(ray.inverse_dot)));
  const FloatVec px = hn::Add(ox, hn::Mul(t_mid, dx));
  const FloatVec py = hn::Add(oy, hn::Mul(t_mid, dy));
  const FloatVec pz = hn::Add(oz, hn::Mul(t_mid, dz));
  const FloatVec squared = hn::Add(hn::Add(hn::Mul(px, px), hn::Mul(py, py)), hn::Mul(pz, pz));
  const FloatVec discriminant = hn::Sub(hn::Mul(radius, radius), squared);
  return {hn::Gt(discriminant, hn::Zero(Floats())), t_mid, discriminant};
}

HWY_INLINE LaneHits enter_spheres(const PreparedRay& ray, const LeafRow* leaf, std::size_t i,
                                  const PassedSpheres& passed, float t_best) {
  const FloatVec t_min = all(ray.t_min), t_max = all(t_best);
  const FloatVec half_chord = hn::Sqrt(hn::Mul(passed.discriminant, all(ray.inverse_dot)));
  const FloatVec first = hn::Sub(passed.t_mid, half_chord);
  const FloatVec second = hn::Add(passed.t_mid, half_chord);
  const FloatVec t = hn::IfThenElse(hn::Ge(first, t_min), first, second);
  const FloatMask mask = hn::And(passed.mask, hn::And(hn::Ge(t, t_min), hn::Le(t, t_max)));
  return enter_sphere_boxes(ray, load_row(leaf, 0, i), load_row(leaf, 1, i), load_row(leaf, 2, i),
                            load_row(leaf, 3, i), {mask, t}, t_max);
}

HWY_INLINE LaneHits intersect_spheres(const PreparedRay& ray, const LeafRow* leaf, std::size_t i,
                                      float t_best) {
  const PassedSpheres passed = pass_spheres(ray, leaf, i);
  if (hn::AllFalse(Floats(), passed.mask)) return {passed.mask, passed.t_mid};
  return enter_spheres(ray, leaf, i, passed, t_best);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
