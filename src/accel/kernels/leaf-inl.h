// Whole leaves at once: the tests of intersect_scalar.h, operation for operation, on vectors.
#include "accel/hit.h"
#include "accel/kernels/simd-inl.h"
#include "scene/leaf.h"

#if defined(DAPPLE_KERNELS_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_LEAF_INL_H
#undef DAPPLE_KERNELS_LEAF_INL_H
#else
#define DAPPLE_KERNELS_LEAF_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Lanes that were hit, and where.
struct LaneHits {
  FloatMask mask;
  FloatVec t;
};

// The own-box rule for the spheres that passed so far.
HWY_INLINE LaneHits enter_sphere_boxes(const PreparedRay& ray, FloatVec cx, FloatVec cy,
                                       FloatVec cz, FloatVec radius, LaneHits hits,
                                       FloatVec t_max) {
  const FloatVec r = hn::Abs(radius);
  const FloatVec x0 = meet(hn::Sub(cx, r), ray, 0), x1 = meet(hn::Add(cx, r), ray, 0);
  const FloatVec y0 = meet(hn::Sub(cy, r), ray, 1), y1 = meet(hn::Add(cy, r), ray, 1);
  const FloatVec z0 = meet(hn::Sub(cz, r), ray, 2), z1 = meet(hn::Add(cz, r), ray, 2);
  const FloatVec near =
      hn::Max(hn::Max(hn::Min(x0, x1), hn::Min(y0, y1)), hn::Max(hn::Min(z0, z1), all(ray.t_min)));
  const FloatVec far = hn::Min(hn::Min(hn::Max(x0, x1), hn::Max(y0, y1)), hn::Max(z0, z1));
  const FloatVec t = hn::Max(hits.t, near);
  const FloatMask inside = hn::And(hn::Le(near, far), hn::Le(t, t_max));
  return {hn::And(hits.mask, inside), t};
}

// Spheres [i, i + kLanes) of a leaf of n.
HWY_INLINE LaneHits intersect_spheres(const PreparedRay& ray, const std::uint32_t* leaf,
                                      std::size_t n, std::size_t i, float t_best) {
  const Floats d;
  const std::uint32_t* words = leaf + i;
  const FloatVec cx = load_floats(words), cy = load_floats(words + n);
  const FloatVec cz = load_floats(words + 2 * n), radius = load_floats(words + 3 * n);
  const FloatVec ox = hn::Sub(all(ray.origin[0]), cx);
  const FloatVec oy = hn::Sub(all(ray.origin[1]), cy);
  const FloatVec oz = hn::Sub(all(ray.origin[2]), cz);
  const FloatVec dx = all(ray.direction[0]), dy = all(ray.direction[1]), dz = all(ray.direction[2]);
  const FloatVec inverse_dot = all(ray.inverse_dot), t_min = all(ray.t_min), t_max = all(t_best);
  const FloatVec along = hn::Add(hn::Add(hn::Mul(ox, dx), hn::Mul(oy, dy)), hn::Mul(oz, dz));
  const FloatVec t_mid = hn::Neg(hn::Mul(along, inverse_dot));
  const FloatVec px = hn::Add(ox, hn::Mul(t_mid, dx));
  const FloatVec py = hn::Add(oy, hn::Mul(t_mid, dy));
  const FloatVec pz = hn::Add(oz, hn::Mul(t_mid, dz));
  const FloatVec squared = hn::Add(hn::Add(hn::Mul(px, px), hn::Mul(py, py)), hn::Mul(pz, pz));
  const FloatVec discriminant = hn::Sub(hn::Mul(radius, radius), squared);
  FloatMask mask = hn::And(hn::Gt(discriminant, hn::Zero(d)), hn::FirstN(d, n - i));
  if (hn::AllFalse(d, mask)) return {mask, t_mid};
  const FloatVec half_chord = hn::Sqrt(hn::Mul(discriminant, inverse_dot));
  const FloatVec first = hn::Sub(t_mid, half_chord);
  const FloatVec second = hn::Add(t_mid, half_chord);
  const FloatVec t = hn::IfThenElse(hn::Ge(first, t_min), first, second);
  mask = hn::And(mask, hn::And(hn::Ge(t, t_min), hn::Le(t, t_max)));
  if (hn::AllFalse(d, mask)) return {mask, t};
  return enter_sphere_boxes(ray, cx, cy, cz, radius, {mask, t}, t_max);
}

// Rectangles [i, i + kLanes) of a leaf of n.
HWY_INLINE LaneHits intersect_rectangles(const PreparedRay& ray, RectangleAxes axes,
                                         const std::uint32_t* leaf, std::size_t n, std::size_t i,
                                         float t_best) {
  const Floats d;
  const std::uint32_t* words = leaf + i;
  const float k_direction = ray.direction[axes.k];
  const bool parallel = k_direction < kSmallestDirection && k_direction > -kSmallestDirection;
  if (parallel) return {hn::FirstN(d, 0), hn::Zero(d)};
  const bool u_up = ray.inverse[axes.u] >= 0.0f, v_up = ray.inverse[axes.v] >= 0.0f;
  const FloatVec u_near = meet(load_floats(words + (u_up ? 0 : n)), ray, axes.u);
  const FloatVec u_far = meet(load_floats(words + (u_up ? n : 0)), ray, axes.u);
  const FloatVec v_near = meet(load_floats(words + (v_up ? 2 * n : 3 * n)), ray, axes.v);
  const FloatVec v_far = meet(load_floats(words + (v_up ? 3 * n : 2 * n)), ray, axes.v);
  const FloatVec t = meet(load_floats(words + 4 * n), ray, axes.k);
  const FloatVec near = hn::Max(hn::Max(u_near, v_near), all(ray.t_min));
  const FloatVec far = hn::Min(hn::Min(u_far, v_far), all(t_best));
  const FloatMask inside = hn::And(hn::Ge(t, near), hn::Le(t, far));
  return {hn::And(inside, hn::FirstN(d, n - i)), t};
}

HWY_INLINE LaneHits intersect_lanes(const PreparedRay& ray, LeafRef leaf,
                                    const std::uint32_t* words, std::size_t i, float t_best) {
  const std::uint32_t* begin = words + leaf.offset();
  if (HWY_LIKELY(leaf.kind() == ShapeKind::sphere)) {
    return intersect_spheres(ray, begin, leaf.count(), i, t_best);
  }
  return intersect_rectangles(ray, rectangle_axes(leaf.kind()), begin, leaf.count(), i, t_best);
}

// Takes the hits in ascending order of ids, which is their order in the leaf.
HWY_INLINE void keep_best(LaneHits hits, LeafRef leaf, const std::uint32_t* words, std::size_t i,
                          Hit& best) {
  alignas(64) float t[16];
  hn::Store(hits.t, Floats(), t);
  std::uint32_t bits = bits_of(hits.mask);
  while (bits != 0) {
    const std::uint32_t lane = take_lowest(bits);
    const LeafRef prim = leaf.lane(i + lane);
    const PrimId id = leaf_prim_id(words, prim);
    if (t[lane] < best.t || (t[lane] == best.t && id < best.prim)) best = {t[lane], id, prim};
  }
}

HWY_INLINE void intersect_leaf(const PreparedRay& ray, LeafRef leaf, const std::uint32_t* words,
                               Hit& best) {
  for (std::size_t i = 0; i < leaf.count(); i += kLanes) {
    const LaneHits hits = intersect_lanes(ray, leaf, words, i, best.t);
    if (!hn::AllFalse(Floats(), hits.mask)) keep_best(hits, leaf, words, i, best);
  }
}

HWY_INLINE bool leaf_occludes(const PreparedRay& ray, LeafRef leaf, const std::uint32_t* words) {
  for (std::size_t i = 0; i < leaf.count(); i += kLanes) {
    const LaneHits hits = intersect_lanes(ray, leaf, words, i, ray.t_max);
    if (!hn::AllFalse(Floats(), hits.mask)) return true;
  }
  return false;
}

// What a search starts from and, when nothing was found, must not return.
HWY_INLINE Hit nothing_before(float t_max) { return {t_max, kNoPrim, {}}; }
HWY_INLINE Hit finished(const Hit& best) { return best.prim == kNoPrim ? Hit{} : best; }

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
