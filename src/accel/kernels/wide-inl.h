// Traversal of the wide BVH: many rays in flight, all children of a node at once.
//
// A thread steps many searches in turn, first those whose next visit is a node, then those whose
// next visit is a leaf. So the memory that one search waits for arrives while others work, and
// almost nothing is left that a branch predictor could get wrong: which lanes were hit is data,
// never control flow.
#include "accel/kernels/dispatch.h"
#include "accel/kernels/packet-inl.h"
#include "accel/kernels/passed-inl.h"
#include "accel/kernels/search-inl.h"

#if defined(DAPPLE_KERNELS_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_WIDE_INL_H
#undef DAPPLE_KERNELS_WIDE_INL_H
#else
#define DAPPLE_KERNELS_WIDE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Asks for the memory that visiting `child` will read: seven cache lines of a node, five or more of
// a leaf. Where these are is computed without a branch, which half the time would be predicted
// wrongly; what is empty gives some address, and asking for that is harmless.
HWY_INLINE void prefetch(const WideBvhView& bvh, ChildRef child) {
  const std::uint64_t bits = child.bits;
  const std::uint64_t if_leaf = 0 - (bits >> 31);
  const auto rows = reinterpret_cast<std::uint64_t>(bvh.rows.data());
  const auto nodes = reinterpret_cast<std::uint64_t>(bvh.nodes.data());
  const std::uint64_t leaf = rows + (bits & ChildRef::kMaxRow) * sizeof(LeafRow);
  const std::uint64_t node = nodes + bits * sizeof(WideNode);
  const char* begin = reinterpret_cast<const char*>((leaf & if_leaf) | (node & ~if_leaf));
  for (int line = 0; line < 7; ++line) __builtin_prefetch(begin + 64 * line);
}

// More hide more latency until their state no longer fits into the first-level cache.
inline constexpr std::size_t kInFlight = 24;

// The searches of a stream, in lists by what they do next.
struct Worklists {
  std::uint8_t at_node[kInFlight] = {}, at_leaf[kInFlight] = {}, ended[kInFlight] = {};
  std::size_t node_count = 0, leaf_count = 0, ended_count = 0;
};

// Files a search under what its stack says is next.
template <bool kAnyHit>
HWY_INLINE void advance(const WideView& bvh, Search& search, std::size_t id, Worklists& lists) {
  search.current = pop<kAnyHit>(search);
  const bool is_leaf = search.current.is_leaf(), is_node = search.current.is_node();
  lists.at_leaf[lists.leaf_count] = lists.at_node[lists.node_count] =
      lists.ended[lists.ended_count] = static_cast<std::uint8_t>(id);
  lists.leaf_count += is_leaf;
  lists.node_count += is_node;
  lists.ended_count += !is_leaf && !is_node;
  if (bvh.far) prefetch(bvh, search.current);
}

// Rays that one thread is given at most before it drains its searches.
inline constexpr std::size_t kChunk = 4096;

// Rays of a job that are traced one by one, and which of them is to be started next.
struct Singles {
  std::uint16_t rays[kChunk];
  std::size_t count = 0, next = 0;

  HWY_INLINE void add(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) rays[count++] = static_cast<std::uint16_t>(i);
  }
  HWY_INLINE bool any_left() const { return next < count; }
};

template <LeafKinds kKinds, bool kAnyHit>
HWY_INLINE void visit_leaves(const WideView& bvh, const Worklists& lists, Search* searches) {
  if constexpr (kKinds == LeafKinds::any) {
    for (std::size_t i = 0; i < lists.leaf_count; ++i) {
      Search& search = searches[lists.at_leaf[i]];
      intersect_leaf<kKinds>(search.ray, search.current.leaf_ref(), bvh.rows.data(),
                             InsideTree<kAnyHit>{bvh}, search.best);
      if (kAnyHit && search.best.prim != kNoPrim) clear(search.pending);
    }
  } else {
    Passed passed[kInFlight * kVecsOfLeaf + 1];
    std::size_t count = 0;
    for (std::size_t i = 0; i < lists.leaf_count; ++i) {
      const std::size_t id = lists.at_leaf[i];
      count += pass_leaf<kKinds>(searches[id], id, bvh.rows.data(), passed + count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      finish_leaf<kKinds, kAnyHit>(passed[i], bvh.rows.data(), searches[passed[i].search]);
    }
  }
}

template <LeafKinds kKinds, class Job>
HWY_NOINLINE void trace_singles(const WideView& bvh, const Job& job, Singles& singles) {
  constexpr bool kAnyHit = Job::kAnyHit;
  Search searches[kInFlight];
  Worklists both[2];
  Worklists *now = &both[0], *next = &both[1];
  const auto start_next = [&](Search& search) {
    const std::size_t ray = singles.rays[singles.next++];
    start<kKinds>(job.rays[ray], ray, search);
  };
  for (Search& search : searches) make_bottom(search.pending);
  for (std::size_t id = 0; id < kInFlight && singles.any_left(); ++id) {
    start_next(searches[id]);
    now->at_node[now->node_count++] = static_cast<std::uint8_t>(id);
  }
  while (now->node_count + now->leaf_count != 0) {
    for (std::size_t i = 0; i < now->node_count; ++i) {
      Search& search = searches[now->at_node[i]];
      visit_node<kAnyHit>(bvh.nodes[search.current.node_index()], search);
    }
    visit_leaves<kKinds, kAnyHit>(bvh, *now, searches);
    next->node_count = next->leaf_count = next->ended_count = 0;
    for (std::size_t i = 0; i < now->node_count; ++i) {
      advance<kAnyHit>(bvh, searches[now->at_node[i]], now->at_node[i], *next);
    }
    for (std::size_t i = 0; i < now->leaf_count; ++i) {
      advance<kAnyHit>(bvh, searches[now->at_leaf[i]], now->at_leaf[i], *next);
    }
    for (std::size_t i = 0; i < next->ended_count; ++i) {
      Search& search = searches[next->ended[i]];
      job.set(search.index, search.best);
      if (!singles.any_left()) continue;
      start_next(search);
      next->at_node[next->node_count++] = next->ended[i];
    }
    Worklists* const done = now;
    now = next;
    next = done;
  }
}

template <class Job>
HWY_INLINE void trace_singles(const WideView& bvh, const Job& job, Singles& singles) {
  switch (bvh.kinds) {
    case LeafKinds::spheres:
      return trace_singles<LeafKinds::spheres>(bvh, job, singles);
    case LeafKinds::triangles:
      return trace_singles<LeafKinds::triangles>(bvh, job, singles);
    case LeafKinds::any:
      return trace_singles<LeafKinds::any>(bvh, job, singles);
  }
}

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

template <class Job, std::size_t kSize>
HWY_INLINE bool try_packet(const WideView& bvh, const Job& job, std::size_t begin,
                           PacketSearch<kSize>& search, Patience& patience) {
  if (!patience.try_now()) return false;
  const bool worked = trace_packet(bvh, job, begin, search);
  patience.learn(worked);
  return worked;
}

// Packets where they work, large ones first; what they leave is traced one by one.
template <class Job>
HWY_INLINE void trace_chunk(const WideView& bvh, const Job& job, std::size_t count,
                            Packets& packets) {
  Singles singles;
  std::size_t i = 0;
  for (; i + kLargePacket <= count; i += kLargePacket) {
    if (try_packet(bvh, job, i, packets.large, packets.with_large)) continue;
    for (std::size_t j = i; j < i + kLargePacket; j += kSmallPacket) {
      if (try_packet(bvh, job, j, packets.small, packets.with_small)) continue;
      singles.add(j, j + kSmallPacket);
    }
  }
  singles.add(i, count);
  trace_singles(bvh, job, singles);
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
