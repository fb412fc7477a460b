// Primitives that meet the rays of a packet, and what the rays keep of that.
#include "accel/kernels/packet_bounds-inl.h"

#if defined(DAPPLE_KERNELS_PACKET_MEET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PACKET_MEET_INL_H
#undef DAPPLE_KERNELS_PACKET_MEET_INL_H
#else
#define DAPPLE_KERNELS_PACKET_MEET_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

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

// Candidates of a leaf one by one: meet(lane) prepares a primitive, and what that returns meets
// rays [i, i + kLanes) with it. Returns the work done.
template <bool kAnyHit, class Packet, class Meet>
HWY_INLINE int meet_candidates(std::uint32_t candidates, ChildRef ref, const std::uint32_t* ids,
                               Packet& packet, const Meet& meet) {
  int work = 0;
  while (candidates != 0) {
    const std::uint32_t lane = take_lowest(candidates);
    if (ids[lane] == kNoPrim) break;
    work += Packet::kPrimWork;
    const auto meet_rays = meet(lane);
    for (std::size_t i = 0; i < Packet::kRays; i += kLanes) {
      const LaneHits hits = meet_rays(i);
      if (any(hits.mask)) keep_nearer<kAnyHit>(hits, i, ids[lane], ref, lane, packet);
    }
  }
  return work;
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
