// Traversal of the wide BVH: packets where rays go the same way, the others one by one.
#include "accel/kernels/dispatch.h"
#include "accel/kernels/packet-inl.h"
#include "accel/kernels/singles-inl.h"
#include "accel/kernels/stream-inl.h"

#if defined(DAPPLE_KERNELS_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_WIDE_INL_H
#undef DAPPLE_KERNELS_WIDE_INL_H
#else
#define DAPPLE_KERNELS_WIDE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Whether trying a packet is worth it: after each failure twice as many are let pass, after each
// success half as many.
struct Patience {
  std::size_t failures = 0, to_skip = 0;

  HWY_INLINE bool try_now() {
    if (to_skip == 0) return true;
    --to_skip;
    return false;
  }
  HWY_INLINE void learn(bool worked) {
    failures = worked ? failures / 2 : failures + (failures < 6);
    to_skip = (std::size_t{1} << failures) - 1;
  }
};

// Packets, and how well those of either size have worked so far.
struct Packets {
  PacketSearch<kLargePacket> large;
  PacketSearch<kSmallPacket> small;
  Patience with_large, with_small;
};

// Packets that are told what leaves hold: those of scenes of one kind that are not compact.
template <LeafKinds kKinds>
inline constexpr LeafKinds kPacketKinds =
    kKinds == LeafKinds::spheres || kKinds == LeafKinds::triangles ? kKinds : LeafKinds::any;

template <LeafKinds kKinds, class Job, std::size_t kSize>
HWY_INLINE bool try_packet(const WideView& bvh, const Job& job, std::size_t begin,
                           PacketSearch<kSize>& search, Patience& patience) {
  if (!patience.try_now()) return false;
  const bool worked = trace_packet<kPacketKinds<kKinds>>(bvh, job, begin, search);
  patience.learn(worked);
  return worked;
}

// Streams need vectors that can be compressed.
template <LeafKinds kKinds>
inline constexpr bool kStreamed = kKinds == LeafKinds::spheres&& HWY_TARGET <= HWY_AVX2;

// Packets where they work, large ones first; of what they leave, streams where those work; the rest
// one by one.
template <LeafKinds kKinds, class Job>
HWY_INLINE void trace_chunk(const WideView& bvh, const Job& job, std::size_t count,
                            Packets& packets) {
  Singles singles;
  std::size_t i = 0;
  for (; i + kLargePacket <= count; i += kLargePacket) {
    if (try_packet<kKinds>(bvh, job, i, packets.large, packets.with_large)) continue;
    for (std::size_t j = i; j < i + kLargePacket; j += kSmallPacket) {
      if (try_packet<kKinds>(bvh, job, j, packets.small, packets.with_small)) continue;
      singles.add(j, j + kSmallPacket);
    }
  }
  singles.add(i, count);
  if constexpr (kStreamed<kKinds>) trace_streams(bvh, job, singles);
  trace_singles<kKinds>(bvh, job, singles);
}

template <class Job>
HWY_INLINE void trace_chunk(const WideView& bvh, const Job& job, std::size_t count,
                            Packets& packets) {
  switch (bvh.kinds) {
    case LeafKinds::spheres:
      return trace_chunk<LeafKinds::spheres>(bvh, job, count, packets);
    case LeafKinds::triangles:
      return trace_chunk<LeafKinds::triangles>(bvh, job, count, packets);
    case LeafKinds::any:
      return trace_chunk<LeafKinds::any>(bvh, job, count, packets);
    case LeafKinds::compact_any:
      return trace_chunk<LeafKinds::compact_any>(bvh, job, count, packets);
    case LeafKinds::compact_triangles:
      return trace_chunk<LeafKinds::compact_triangles>(bvh, job, count, packets);
  }
}

HWY_ATTR void intersect_wide(const WideView& bvh, const Ray* rays, Hit* hits, std::size_t count) {
  if (bvh.empty()) {
    for (std::size_t i = 0; i < count; ++i) hits[i] = Hit{};
    return;
  }
  Packets packets;
  for (std::size_t i = 0; i < count; i += kChunk) {
    trace_chunk(bvh, ClosestHits{rays + i, hits + i}, count - i < kChunk ? count - i : kChunk,
                packets);
  }
}

HWY_ATTR void occluded_wide(const WideView& bvh, const Ray* rays, std::uint8_t* occluded,
                            std::size_t count) {
  if (bvh.empty()) {
    for (std::size_t i = 0; i < count; ++i) occluded[i] = 0;
    return;
  }
  Packets packets;
  for (std::size_t i = 0; i < count; i += kChunk) {
    trace_chunk(bvh, AnyHits{rays + i, occluded + i}, count - i < kChunk ? count - i : kChunk,
                packets);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
