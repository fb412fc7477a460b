// Leaves of triangles: first which of them a ray's line passes, then where the ray meets those.
#include "accel/kernels/leaf_lanes-inl.h"

#if defined(DAPPLE_KERNELS_LEAF_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_LEAF_TRIANGLES_INL_H
#undef DAPPLE_KERNELS_LEAF_TRIANGLES_INL_H
#else
#define DAPPLE_KERNELS_LEAF_TRIANGLES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// A coordinate of a triangle's vertices in three rows, and its extent.
HWY_INLINE FloatVec least_of(const LeafRow* leaf, std::size_t axis, std::size_t i) {
  return hn::Min(hn::Min(load_row(leaf, axis, i), load_row(leaf, 3 + axis, i)),
                 load_row(leaf, 6 + axis, i));
}
HWY_INLINE FloatVec greatest_of(const LeafRow* leaf, std::size_t axis, std::size_t i) {
  return hn::Max(hn::Max(load_row(leaf, axis, i), load_row(leaf, 3 + axis, i)),
                 load_row(leaf, 6 + axis, i));
}

// The own-box rule for the triangles that passed so far.
HWY_INLINE LaneHits enter_triangle_boxes(const PreparedRay& ray, const LeafRow* leaf, std::size_t i,
                                         LaneHits hits, FloatVec t_max) {
  FloatVec near = all(ray.t_min), far = all(Bounds3f::kInfinity);
  for (int axis = 0; axis < 3; ++axis) {
    const auto row = static_cast<std::size_t>(axis);
    const FloatVec lo = least_of(leaf, row, i), hi = greatest_of(leaf, row, i);
    const FloatMask up = hn::Ge(all(ray.inverse[axis]), hn::Zero(Floats()));
    near = hn::Max(near, meet(hn::IfThenElse(up, lo, hi), ray, axis));
    far = hn::Min(far, meet_far(hn::IfThenElse(up, hi, lo), ray, axis));
  }
  const FloatVec t = hn::Min(hn::Max(hits.t, near), far);
  const FloatMask inside = hn::And(hn::Le(near, far), hn::Le(t, t_max));
  return {hn::And(hits.mask, inside), t};
}

// Vertices in a ray's own frame.
struct SeenVertex {
  FloatVec x, y, z;
};

HWY_INLINE SeenVertex see_vertex(const PreparedRay& ray, const LeafRow* leaf, std::size_t row,
                                 std::size_t i) {
  const std::uint32_t kz = ray.axis, kx = next_axis(kz), ky = next_axis(kx);
  const FloatVec z = hn::Sub(load_row(leaf, row + kz, i), all(ray.origin[kz]));
  const FloatVec x = hn::Sub(load_row(leaf, row + kx, i), all(ray.origin[kx]));
  const FloatVec y = hn::Sub(load_row(leaf, row + ky, i), all(ray.origin[ky]));
  return {hn::Sub(x, hn::Mul(all(ray.shear[0]), z)), hn::Sub(y, hn::Mul(all(ray.shear[1]), z)), z};
}

// Triangles of which the ray's line passes those of the mask: the weights of their vertices where
// it does, not scaled to a sum of one, and the vertices' z.
struct PassedTriangles {
  FloatMask mask;
  FloatVec weights[3], z[3];
};

// Triangles [i, i + kLanes) of a leaf.
HWY_INLINE PassedTriangles pass_triangles(const PreparedRay& ray, const LeafRow* leaf,
                                          std::size_t i) {
  const FloatVec zero = hn::Zero(Floats());
  const SeenVertex a = see_vertex(ray, leaf, 0, i);
  const SeenVertex b = see_vertex(ray, leaf, 3, i);
  const SeenVertex c = see_vertex(ray, leaf, 6, i);
  const FloatVec u0 = hn::Sub(hn::Mul(c.x, b.y), hn::Mul(c.y, b.x));
  const FloatVec u1 = hn::Sub(hn::Mul(a.x, c.y), hn::Mul(a.y, c.x));
  const FloatVec u2 = hn::Sub(hn::Mul(b.x, a.y), hn::Mul(b.y, a.x));
  const FloatVec sum = hn::Add(hn::Add(u0, u1), u2);
  const FloatMask inside = hn::Or(hn::Ge(hn::Min(hn::Min(u0, u1), u2), zero),
                                  hn::Le(hn::Max(hn::Max(u0, u1), u2), zero));
  return {hn::And(inside, hn::Gt(hn::Abs(sum), zero)), {u0, u1, u2}, {a.z, b.z, c.z}};
}

HWY_INLINE LaneHits enter_triangles(const PreparedRay& ray, const LeafRow* leaf, std::size_t i,
                                    const PassedTriangles& passed, float t_best) {
  const auto& u = passed.weights;
  const FloatVec sum = hn::Add(hn::Add(u[0], u[1]), u[2]);
  const FloatVec scale = hn::Div(all(1.0f), sum);
  const FloatVec z = hn::Add(hn::Add(hn::Mul(hn::Mul(u[0], scale), passed.z[0]),
                                     hn::Mul(hn::Mul(u[1], scale), passed.z[1])),
                             hn::Mul(hn::Mul(u[2], scale), passed.z[2]));
  const FloatVec t = hn::Mul(z, all(ray.inverse[ray.axis]));
  const FloatMask mask = hn::And(passed.mask, hn::Ge(t, all(ray.t_min)));
  return enter_triangle_boxes(ray, leaf, i, {mask, t}, all(t_best));
}

HWY_INLINE LaneHits intersect_triangles(const PreparedRay& ray, const LeafRow* leaf, std::size_t i,
                                        float t_best) {
  const PassedTriangles passed = pass_triangles(ray, leaf, i);
  if (hn::AllFalse(Floats(), passed.mask)) return {passed.mask, passed.z[0]};
  return enter_triangles(ray, leaf, i, passed, t_best);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
