// A packet in a leaf: primitives whose own box it may pass, each against all rays at once.
#include "accel/kernels/packet_bounds-inl.h"

#if defined(DAPPLE_KERNELS_PACKET_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PACKET_LEAF_INL_H
#undef DAPPLE_KERNELS_PACKET_LEAF_INL_H
#else
#define DAPPLE_KERNELS_PACKET_LEAF_INL_H
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

template <class Packet>
HWY_INLINE LaneHits meet_rectangle(const Packet& packet, std::size_t i, RectangleAxes axes,
                                   const PacketBounds& bounds, const float* numbers) {
  const auto cross = [&](float plane, int axis) {
    return hn::Mul(hn::Sub(all(plane), load_floats(packet.origin[axis] + i)),
                   load_floats(packet.inverse[axis] + i));
  };
  const bool u_up = bounds.up[axes.u], v_up = bounds.up[axes.v];
  const FloatVec t = cross(numbers[4], axes.k);
  const FloatVec near =
      hn::Max(hn::Max(cross(numbers[u_up ? 0 : 1], axes.u), cross(numbers[v_up ? 2 : 3], axes.v)),
              load_floats(packet.t_min + i));
  const FloatVec far =
      hn::Min(hn::Min(cross(numbers[u_up ? 1 : 0], axes.u), cross(numbers[v_up ? 3 : 2], axes.v)),
              load_floats(packet.best_t + i));
  const FloatVec steep = hn::Abs(load_floats(packet.direction[axes.k] + i));
  const FloatMask crosses = hn::Ge(steep, all(kSmallestDirection));
  return {hn::And(crosses, hn::And(hn::Ge(t, near), hn::Le(t, far))), t};
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

// Keeps what is nearer than before, or as near with a lower id. A ray for which any hit will do
// looks for nothing more.
template <bool kAnyHit, class Packet>
HWY_INLINE void keep_nearer(LaneHits hits, std::size_t i, PrimId id, ChildRef leaf,
                            std::size_t lane, Packet& packet) {
  const Floats d;
  const Words w;
  const FloatVec best_t = load_floats(packet.best_t + i);
  const WordVec best_prim = hn::Load(w, packet.best_prim + i);
  const WordVec prim = hn::Set(w, id);
  const FloatMask lower = hn::RebindMask(d, hn::Lt(prim, best_prim));
  const FloatMask better =
      hn::And(hits.mask, hn::Or(hn::Lt(hits.t, best_t), hn::And(hn::Eq(hits.t, best_t), lower)));
  const auto better_words = hn::RebindMask(w, better);
  const auto keep = [&](std::uint32_t* to, WordVec value) {
    hn::Store(hn::IfThenElse(better_words, value, hn::Load(w, to + i)), w, to + i);
  };
  const FloatVec next = kAnyHit ? all(-1.0f) : hits.t;
  hn::Store(hn::IfThenElse(better, next, best_t), d, packet.best_t + i);
  keep(packet.best_prim, prim);
  keep(packet.best_leaf, hn::Set(w, leaf.bits));
  keep(packet.best_lane, hn::Set(w, static_cast<std::uint32_t>(lane)));
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

HWY_INLINE std::uint32_t candidate_triangles(const PacketBounds& bounds, const LeafRow* leaf) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
    FloatVec lo[3], hi[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lo[axis] = least_of(leaf, axis, i);
      hi[axis] = greatest_of(leaf, axis, i);
    }
    bits |= bits_of(enter_boxes(bounds, lo, hi).mask) << i;
  }
  return bits;
}

// Returns the work done.
template <bool kAnyHit, class Packet>
HWY_INLINE int visit_leaf(const PacketBounds& bounds, ChildRef ref, const LeafRow* rows,
                          Packet& packet) {
  const ShapeKind kind = ref.leaf_kind();
  const LeafRow* leaf = rows + ref.leaf_row();
  const std::uint32_t* ids = leaf[leaf_id_row(kind)].words;
  const bool is_sphere = kind == ShapeKind::sphere;
  const bool is_triangle = kind == ShapeKind::triangle;
  std::uint32_t candidates = is_sphere     ? candidate_spheres(bounds, leaf)
                             : is_triangle ? candidate_triangles(bounds, leaf)
                                           : 0xffffu;
  int work = kNodeWork;
  while (candidates != 0) {
    const std::uint32_t lane = take_lowest(candidates);
    if (ids[lane] == kNoPrim) break;
    work += Packet::kPrimWork;
    if (is_sphere) {
      const OneSphere sphere = spread_sphere(leaf, lane);
      for (std::size_t i = 0; i < Packet::kRays; i += kLanes) {
        const LaneHits hits = meet_sphere(packet, i, sphere);
        if (!hn::AllFalse(Floats(), hits.mask)) {
          keep_nearer<kAnyHit>(hits, i, ids[lane], ref, lane, packet);
        }
      }
      continue;
    }
    float numbers[kMaxLeafRows];
    for (std::size_t row = 0; row < leaf_id_row(kind); ++row) {
      numbers[row] = load_float(leaf[row].words + lane);
    }
    if (is_triangle) {
      for (std::size_t i = 0; i < Packet::kRays; i += kLanes) {
        const LaneHits hits = meet_triangle(packet, i, bounds, numbers);
        if (!hn::AllFalse(Floats(), hits.mask)) {
          keep_nearer<kAnyHit>(hits, i, ids[lane], ref, lane, packet);
        }
      }
      continue;
    }
    for (std::size_t i = 0; i < Packet::kRays; i += kLanes) {
      const LaneHits hits = meet_rectangle(packet, i, rectangle_axes(kind), bounds, numbers);
      keep_nearer<kAnyHit>(hits, i, ids[lane], ref, lane, packet);
    }
  }
  return work;
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
