// A packet in a leaf of triangles. Where triangles are smaller than what lies between two rays, few
// rays come near a leaf at all, and each of them is tested with all its triangles at once.
#include "accel/kernels/packet_meet-inl.h"

#if defined(DAPPLE_KERNELS_PACKET_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PACKET_TRIANGLES_INL_H
#undef DAPPLE_KERNELS_PACKET_TRIANGLES_INL_H
#else
#define DAPPLE_KERNELS_PACKET_TRIANGLES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct OneTriangle {
  float numbers[9];
};

HWY_INLINE OneTriangle take_triangle(const LeafRow* leaf, std::size_t lane) {
  OneTriangle triangle;
  for (std::size_t row = 0; row < 9; ++row) {
    triangle.numbers[row] = load_float(leaf[row].words + lane);
  }
  return triangle;
}

// One triangle, as all its lanes, with rays [i, i + kLanes) that have one axis.
template <class Packet>
HWY_INLINE LaneHits meet_triangle(const Packet& packet, std::size_t i, const PacketBounds& bounds,
                                  const float* v) {
  const Floats d;
  const FloatVec zero = hn::Zero(d);
  const std::uint32_t kz = bounds.axis, kx = next_axis(kz), ky = next_axis(kx);
  const FloatVec ox = load_floats(packet.origin[kx] + i), oy = load_floats(packet.origin[ky] + i);
  const FloatVec oz = load_floats(packet.origin[kz] + i);
  const FloatVec shear_x = load_floats(packet.shear[0] + i);
  const FloatVec shear_y = load_floats(packet.shear[1] + i);
  FloatVec x[3], y[3], z[3];
  for (std::size_t k = 0; k < 3; ++k) {
    z[k] = hn::Sub(all(v[3 * k + kz]), oz);
    x[k] = hn::Sub(hn::Sub(all(v[3 * k + kx]), ox), hn::Mul(shear_x, z[k]));
    y[k] = hn::Sub(hn::Sub(all(v[3 * k + ky]), oy), hn::Mul(shear_y, z[k]));
  }
  const FloatVec u0 = hn::Sub(hn::Mul(x[2], y[1]), hn::Mul(y[2], x[1]));
  const FloatVec u1 = hn::Sub(hn::Mul(x[0], y[2]), hn::Mul(y[0], x[2]));
  const FloatVec u2 = hn::Sub(hn::Mul(x[1], y[0]), hn::Mul(y[1], x[0]));
  const FloatVec sum = hn::Add(hn::Add(u0, u1), u2);
  const FloatMask inside = hn::Or(hn::Ge(hn::Min(hn::Min(u0, u1), u2), zero),
                                  hn::Le(hn::Max(hn::Max(u0, u1), u2), zero));
  FloatMask mask = hn::And(inside, hn::Gt(hn::Abs(sum), zero));
  if (hn::AllFalse(d, mask)) return {mask, zero};
  const FloatVec scale = hn::Div(all(1.0f), sum);
  const FloatVec ahead =
      hn::Add(hn::Add(hn::Mul(hn::Mul(u0, scale), z[0]), hn::Mul(hn::Mul(u1, scale), z[1])),
              hn::Mul(hn::Mul(u2, scale), z[2]));
  const FloatVec raw = hn::Mul(ahead, load_floats(packet.inverse[kz] + i));
  const FloatVec t_min = load_floats(packet.t_min + i), t_max = load_floats(packet.best_t + i);
  mask = hn::And(mask, hn::Ge(raw, t_min));
  FloatVec near = t_min, far = all(Bounds3f::kInfinity);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto least = [](float a, float b) { return a < b ? a : b; };
    const auto most = [](float a, float b) { return a > b ? a : b; };
    const float lo = least(least(v[axis], v[3 + axis]), v[6 + axis]);
    const float hi = most(most(v[axis], v[3 + axis]), v[6 + axis]);
    const FloatVec o = load_floats(packet.origin[axis] + i);
    const FloatVec inverse = load_floats(packet.inverse[axis] + i);
    const bool up = bounds.up[axis];
    near = hn::Max(near, hn::Mul(hn::Sub(all(up ? lo : hi), o), inverse));
    far = hn::Min(far, hn::Mul(hn::Sub(all(up ? hi : lo), o), hn::Mul(inverse, all(kFarPad))));
  }
  const FloatVec t = hn::Min(hn::Max(raw, near), far);
  return {hn::And(mask, hn::And(hn::Le(near, far), hn::Le(t, t_max))), t};
}

// Triangles of a leaf whose own box the packet may pass, and the box of these.
struct CandidateTriangles {
  std::uint32_t bits = 0;
  FloatVec lo[3], hi[3];

  HWY_INLINE CandidateTriangles(const PacketBounds& bounds, const LeafRow* leaf) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lo[axis] = all(Bounds3f::kInfinity);
      hi[axis] = all(-Bounds3f::kInfinity);
    }
    for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
      FloatVec least[3], greatest[3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        least[axis] = least_of(leaf, axis, i);
        greatest[axis] = greatest_of(leaf, axis, i);
      }
      const FloatMask mask = enter_boxes(bounds, least, greatest).mask;
      bits |= bits_of(mask) << i;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        lo[axis] = hn::IfThenElse(mask, hn::Min(lo[axis], least[axis]), lo[axis]);
        hi[axis] = hn::IfThenElse(mask, hn::Max(hi[axis], greatest[axis]), hi[axis]);
      }
    }
  }
};

// Rays of the packet that pass the box of the candidates in time; bit i for ray i.
template <class Packet>
HWY_INLINE std::uint64_t rays_in_box(const Packet& packet, const PacketBounds& bounds,
                                     const CandidateTriangles& candidates) {
  FloatVec first[3], last[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const FloatVec lo = hn::MinOfLanes(Floats(), candidates.lo[axis]);
    const FloatVec hi = hn::MaxOfLanes(Floats(), candidates.hi[axis]);
    first[axis] = bounds.up[axis] ? lo : hi;
    last[axis] = bounds.up[axis] ? hi : lo;
  }
  std::uint64_t rays = 0;
  for (std::size_t i = 0; i < Packet::kRays; i += kLanes) {
    FloatVec near = load_floats(packet.t_min + i), far = load_floats(packet.best_t + i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const FloatVec o = load_floats(packet.origin[axis] + i);
      const FloatVec inverse = load_floats(packet.inverse[axis] + i);
      near = hn::Max(near, hn::Mul(hn::Sub(first[axis], o), inverse));
      far = hn::Min(far, hn::Mul(hn::Sub(last[axis], o), hn::Mul(inverse, all(kFarPad))));
    }
    rays |= std::uint64_t{bits_of(hn::Le(near, far))} << i;
  }
  return rays;
}

// One of the packet's rays by itself, with what triangles need.
template <class Packet>
HWY_INLINE void take_ray(const Packet& packet, const PacketBounds& bounds, std::size_t i,
                         PreparedRay& ray) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = packet.origin[axis][i];
    ray.direction[axis] = packet.direction[axis][i];
    ray.inverse[axis] = packet.inverse[axis][i];
    ray.inverse_far[axis] = packet.inverse[axis][i] * kFarPad;
  }
  ray.t_min = packet.t_min[i];
  ray.axis = bounds.axis;
  ray.shear[0] = packet.shear[0][i];
  ray.shear[1] = packet.shear[1][i];
}

// Each of some rays with all triangles of a leaf.
template <bool kAnyHit, class Packet>
HWY_INLINE void meet_triangles(std::uint64_t rays, const PacketBounds& bounds, ChildRef ref,
                               const LeafRow* leaf, Packet& packet) {
  PreparedRay prepared;
  for (; rays != 0; rays &= rays - 1) {
    const auto ray = static_cast<std::size_t>(__builtin_ctzll(rays));
    take_ray(packet, bounds, ray, prepared);
    Hit best = {packet.best_t[ray], packet.best_prim[ray], {}};
    for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
      const LaneHits hits = intersect_triangles(prepared, leaf, i, best.t);
      if (any(hits.mask)) keep_best(hits, ref.leaf_ref(), leaf, i, best);
    }
    if (best.prim == packet.best_prim[ray]) continue;
    packet.best_t[ray] = kAnyHit ? -1.0f : best.t;
    packet.best_prim[ray] = best.prim;
    packet.best_leaf[ray] = ref.bits;
    packet.best_lane[ray] = static_cast<std::uint32_t>(best.lane.lane_index());
  }
}

// Whichever is less work: the rays that come near, each with all triangles, or the candidates, each
// with all rays.
template <bool kAnyHit, class Packet>
HWY_INLINE int visit_triangles(const PacketBounds& bounds, ChildRef ref, const LeafRow* leaf,
                               Packet& packet) {
  const CandidateTriangles candidates(bounds, leaf);
  const int count = __builtin_popcount(candidates.bits);
  if (count > 1) {
    const std::uint64_t rays = rays_in_box(packet, bounds, candidates);
    const int ray_count = __builtin_popcountll(rays);
    if (ray_count <= count * static_cast<int>(Packet::kRays / kLeafWidth)) {
      meet_triangles<kAnyHit>(rays, bounds, ref, leaf, packet);
      return ray_count * kRayWork;
    }
  }
  const std::uint32_t* ids = leaf[leaf_id_row(ShapeKind::triangle)].words;
  return meet_candidates<kAnyHit>(
      candidates.bits, ref, ids, packet, [&](std::uint32_t lane) HWY_ATTR {
        return [&packet, &bounds, triangle = take_triangle(leaf, lane)](std::size_t i)
                   HWY_ATTR { return meet_triangle(packet, i, bounds, triangle.numbers); };
      });
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
