// The rays of a packet and what they have in common: intervals of origins and inverse directions.
#include "accel/kernels/prepare-inl.h"
#include "accel/kernels/push-inl.h"

#if defined(DAPPLE_KERNELS_PACKET_BOUNDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PACKET_BOUNDS_INL_H
#undef DAPPLE_KERNELS_PACKET_BOUNDS_INL_H
#else
#define DAPPLE_KERNELS_PACKET_BOUNDS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Large packets where many rays meet the same shapes, small ones where they part sooner.
inline constexpr std::size_t kLargePacket = 64, kSmallPacket = 16;
// Work after which a packet gives up: its rays have less in common than it seemed. Of spheres a
// large one gives up soon, since small ones are tried after it; of triangles even rays that meet
// little together mostly share the way there. With twice as much long thin triangles gain, with
// half as much meshes far finer than the picture.
template <LeafKinds kKinds, std::size_t kSize>
inline constexpr int kBudget = kSize == kSmallPacket            ? 640
                               : kKinds == LeafKinds::triangles ? 1280
                                                                : 320;
inline constexpr int kNodeWork = 2, kRayWork = 2;

template <std::size_t kSize>
struct alignas(64) Packet {
  static constexpr std::size_t kRays = kSize;
  static constexpr int kPrimWork = 1 + static_cast<int>(kSize / 16);

  float origin[3][kSize], direction[3][kSize], inverse[3][kSize];
  float t_min[kSize];
  float inverse_dot[kSize];  // filled in at the first leaf of spheres: divisions take long
  float shear[2][kSize];
  float best_t[kSize];  // negative for a ray that looks for nothing more
  std::uint32_t best_prim[kSize];
  std::uint32_t best_leaf[kSize], best_lane[kSize];  // ChildRef bits, lane in it
  bool has_inverse_dot;
};

// What all rays of a packet have in common.
struct PacketBounds {
  float origin_near[3], origin_far[3];  // the ends that give the first and last crossing of a plane
  float inverse_low[3], inverse_high[3];
  float inverse_far_low[3], inverse_far_high[3];
  std::uint32_t axis;  // the z of the rays' own frames
  bool one_axis;       // it is the same for all
  bool up[3];          // signs of the directions
  float t_min;         // smallest
  float t_best;        // largest
};

struct Extent {
  float low, high;
};

template <std::size_t kSize>
HWY_INLINE Extent extent_of(const float (&values)[kSize]) {
  FloatVec low = load_floats(values), high = low;
  for (std::size_t i = kLanes; i < kSize; i += kLanes) {
    low = hn::Min(low, load_floats(values + i));
    high = hn::Max(high, load_floats(values + i));
  }
  return {hn::GetLane(hn::MinOfLanes(Floats(), low)), hn::GetLane(hn::MaxOfLanes(Floats(), high))};
}

// False when the signs of the directions differ or a ray is unusable.
template <class Packet>
HWY_INLINE bool bound(const Packet& packet, PacketBounds& bounds) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Extent inverse = extent_of(packet.inverse[axis]);
    const Extent origin = extent_of(packet.origin[axis]);
    if (!(inverse.low > 0.0f || inverse.high < 0.0f)) return false;
    const bool up = inverse.low > 0.0f;
    bounds.up[axis] = up;
    bounds.inverse_low[axis] = inverse.low;
    bounds.inverse_high[axis] = inverse.high;
    bounds.inverse_far_low[axis] = inverse.low * kFarPad;
    bounds.inverse_far_high[axis] = inverse.high * kFarPad;
    bounds.origin_near[axis] = up ? origin.high : origin.low;
    bounds.origin_far[axis] = up ? origin.low : origin.high;
  }
  bounds.t_min = extent_of(packet.t_min).low;
  const Extent best = extent_of(packet.best_t);
  bounds.t_best = best.high;
  return best.low >= 0.0f;
}

template <LeafKinds kKinds, class Packet>
HWY_INLINE void fill(const Ray* from, Packet& packet, PacketBounds& bounds) {
  const Floats d;
  const Words w;
  WordMask same_axis = hn::FirstN(w, kLanes);
  packet.has_inverse_dot = false;
  for (std::size_t i = 0; i < Packet::kRays; i += kLanes) {
    // The next packet's, most likely; two rays a cache line.
    for (std::size_t k = 0; k < kLanes; k += 2) __builtin_prefetch(from + Packet::kRays + i + k);
    const RayLanes rays = load_rays(from + i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hn::Store(rays.origin[axis], d, packet.origin[axis] + i);
      hn::Store(rays.direction[axis], d, packet.direction[axis] + i);
      hn::Store(rays.inverse[axis], d, packet.inverse[axis] + i);
    }
    hn::Store(rays.t_min, d, packet.t_min + i);
    hn::Store(rays.t_max, d, packet.best_t + i);
    hn::Store(hn::Set(w, kNoPrim), w, packet.best_prim + i);
    if (kKinds == LeafKinds::spheres) continue;
    const FrameLanes frames = frames_of(rays);
    if (i == 0) bounds.axis = hn::GetLane(frames.axis);
    same_axis = hn::And(same_axis, hn::Eq(frames.axis, hn::Set(w, bounds.axis)));
    for (std::size_t k = 0; k < 2; ++k) hn::Store(frames.shear[k], d, packet.shear[k] + i);
  }
  bounds.one_axis = hn::AllTrue(w, same_axis);
}

template <class Packet>
HWY_INLINE void fill_inverse_dot(Packet& packet) {
  if (packet.has_inverse_dot) return;
  packet.has_inverse_dot = true;
  for (std::size_t i = 0; i < Packet::kRays; i += kLanes) {
    const FloatVec direction[3] = {load_floats(packet.direction[0] + i),
                                   load_floats(packet.direction[1] + i),
                                   load_floats(packet.direction[2] + i)};
    hn::Store(hn::Div(all(1.0f), squared_length(direction)), Floats(), packet.inverse_dot + i);
  }
}

// The earliest and latest distances at which any ray of the packet crosses planes of one axis.
HWY_INLINE FloatVec earliest(FloatVec planes, const PacketBounds& bounds, std::size_t axis) {
  const FloatVec way = hn::Sub(planes, all(bounds.origin_near[axis]));
  return hn::Min(hn::Mul(way, all(bounds.inverse_low[axis])),
                 hn::Mul(way, all(bounds.inverse_high[axis])));
}
HWY_INLINE FloatVec latest(FloatVec planes, const PacketBounds& bounds, std::size_t axis) {
  const FloatVec way = hn::Sub(planes, all(bounds.origin_far[axis]));
  return hn::Max(hn::Mul(way, all(bounds.inverse_far_low[axis])),
                 hn::Mul(way, all(bounds.inverse_far_high[axis])));
}

// Boxes that some ray of the packet may pass, and when at the earliest.
HWY_INLINE LaneHits enter_boxes(const PacketBounds& bounds, const FloatVec* lo,
                                const FloatVec* hi) {
  FloatVec entry = all(bounds.t_min), exit = all(bounds.t_best);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool up = bounds.up[axis];
    entry = hn::Max(entry, earliest(up ? lo[axis] : hi[axis], bounds, axis));
    exit = hn::Min(exit, latest(up ? hi[axis] : lo[axis], bounds, axis));
  }
  return {hn::Le(entry, exit), entry};
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
