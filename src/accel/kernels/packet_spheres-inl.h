// A packet in a leaf of spheres: those whose own box it may pass, each with all rays at once.
#include "accel/kernels/meet_sphere-inl.h"
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

// One sphere in all lanes.
HWY_INLINE SphereLanes spread_sphere(const LeafRow* leaf, std::size_t lane) {
  SphereLanes sphere;
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

// Rays [i, i + kLanes), not beyond what they found so far.
template <class Packet>
HWY_INLINE RayLanes rays_of(const Packet& packet, std::size_t i) {
  RayLanes rays;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] = load_floats(packet.origin[axis] + i);
    rays.direction[axis] = load_floats(packet.direction[axis] + i);
    rays.inverse[axis] = load_floats(packet.inverse[axis] + i);
  }
  rays.t_min = load_floats(packet.t_min + i);
  rays.t_max = load_floats(packet.best_t + i);
  rays.inverse_dot = load_floats(packet.inverse_dot + i);
  return rays;
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
  fill_inverse_dot(packet);
  return meet_candidates<kAnyHit>(
      candidate_spheres(bounds, leaf), ref, ids, packet, [&](std::uint32_t lane) HWY_ATTR {
        return [&packet, sphere = spread_sphere(leaf, lane)](std::size_t i)
                   HWY_ATTR { return meet_spheres<true>(rays_of(packet, i), sphere); };
      });
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
