// A packet in a leaf of spheres: those whose own box it may pass, each with all rays at once.
#include "accel/kernels/packet_meet-inl.h"

#if defined(DAPPLE_KERNELS_PACKET_SPHERES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PACKET_SPHERES_INL_H
#undef DAPPLE_KERNELS_PACKET_SPHERES_INL_H
#else
#define DAPPLE_KERNELS_PACKET_SPHERES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// One sphere, as all its lanes, with rays [i, i + kLanes): intersect_spheres the other way round.
struct OneSphere {
  FloatVec c[3], radius, lo[3], hi[3];
};

HWY_INLINE OneSphere spread_sphere(const LeafRow* leaf, std::size_t lane) {
  OneSphere sphere;
  const float radius = load_float(leaf[3].words + lane);
  const float size = radius < 0.0f ? -radius : radius;
  sphere.radius = all(radius);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float c = load_float(leaf[axis].words + lane);
    sphere.c[axis] = all(c);
    sphere.lo[axis] = all(c - size);
    sphere.hi[axis] = all(c + size);
  }
  return sphere;
}

template <class Packet>
HWY_INLINE LaneHits meet_sphere(const Packet& packet, std::size_t i, const OneSphere& sphere) {
  const Floats d;
  FloatVec o[3], dir[3], from[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    o[axis] = load_floats(packet.origin[axis] + i);
    dir[axis] = load_floats(packet.direction[axis] + i);
    from[axis] = hn::Sub(o[axis], sphere.c[axis]);
  }
  const FloatVec inverse_dot = load_floats(packet.inverse_dot + i);
  const FloatVec along = hn::Add(hn::Add(hn::Mul(from[0], dir[0]), hn::Mul(from[1], dir[1])),
                                 hn::Mul(from[2], dir[2]));
  const FloatVec t_mid = hn::Neg(hn::Mul(along, inverse_dot));
  const FloatVec px = hn::Add(from[0], hn::Mul(t_mid, dir[0]));
  const FloatVec py = hn::Add(from[1], hn::Mul(t_mid, dir[1]));
  const FloatVec pz = hn::Add(from[2], hn::Mul(t_mid, dir[2]));
  const FloatVec squared = hn::Add(hn::Add(hn::Mul(px, px), hn::Mul(py, py)), hn::Mul(pz, pz));
  const FloatVec discriminant = hn::Sub(hn::Mul(sphere.radius, sphere.radius), squared);
  FloatMask mask = hn::Gt(discriminant, hn::Zero(d));
  if (hn::AllFalse(d, mask)) return {mask, t_mid};
  const FloatVec t_min = load_floats(packet.t_min + i), t_max = load_floats(packet.best_t + i);
  const FloatVec half_chord = hn::Sqrt(hn::Mul(discriminant, inverse_dot));
  const FloatVec first = hn::Sub(t_mid, half_chord);
  const FloatVec raw = hn::IfThenElse(hn::Ge(first, t_min), first, hn::Add(t_mid, half_chord));
  mask = hn::And(mask, hn::And(hn::Ge(raw, t_min), hn::Le(raw, t_max)));
  FloatVec near = t_min, far = all(Bounds3f::kInfinity);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const FloatVec inverse = load_floats(packet.inverse[axis] + i);
    const FloatVec to_lo = hn::Mul(hn::Sub(sphere.lo[axis], o[axis]), inverse);
    const FloatVec to_hi = hn::Mul(hn::Sub(sphere.hi[axis], o[axis]), inverse);
    near = hn::Max(hn::Min(to_lo, to_hi), near);
    far = hn::Min(hn::Max(to_lo, to_hi), far);
  }
  const FloatVec t = hn::Max(raw, near);
  return {hn::And(mask, hn::And(hn::Le(near, far), hn::Le(t, t_max))), t};
}

// Spheres of a leaf whose own box the packet may pass; bit i for lane i.
HWY_INLINE std::uint32_t candidate_spheres(const PacketBounds& bounds, const LeafRow* leaf) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
    const FloatVec size = hn::Abs(load_row(leaf, 3, i));
    FloatVec lo[3], hi[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const FloatVec c = load_row(leaf, axis, i);
      lo[axis] = hn::Sub(c, size);
      hi[axis] = hn::Add(c, size);
    }
    bits |= bits_of(enter_boxes(bounds, lo, hi).mask) << i;
  }
  return bits;
}

template <bool kAnyHit, class Packet>
HWY_INLINE int visit_spheres(const PacketBounds& bounds, ChildRef ref, const LeafRow* leaf,
                             Packet& packet) {
  const std::uint32_t* ids = leaf[leaf_id_row(ShapeKind::sphere)].words;
  return meet_candidates<kAnyHit>(
      candidate_spheres(bounds, leaf), ref, ids, packet, [&](std::uint32_t lane) HWY_ATTR {
        return [&packet, sphere = spread_sphere(leaf, lane)](std::size_t i)
                   HWY_ATTR { return meet_sphere(packet, i, sphere); };
      });
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
