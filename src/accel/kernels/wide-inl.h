// Traversal of the wide BVH: many rays in flight, all children of a node at once.
//
// A thread steps many searches in turn, first those whose next visit is a node, then those whose
// next visit is a leaf. So the memory that one search waits for arrives while others work, and
// almost nothing is left that a branch predictor could get wrong: which lanes were hit is data,
// never control flow.
#include "accel/kernels/dispatch.h"
#include "accel/kernels/packet-inl.h"
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

// Rays of a stream still to be started, and what to do with a search that ended.
template <class Finish>
struct Stream {
  const Ray* rays;
  std::size_t count;
  std::size_t next;
  Finish finish;
};

template <LeafKinds kKinds, bool kAnyHit, class Finish>
HWY_INLINE void trace_stream(const WideView& bvh, Stream<Finish> stream) {
  Search searches[kInFlight];
  Worklists both[2];
  Worklists *now = &both[0], *next = &both[1];
  for (Search& search : searches) make_bottom(search.pending);
  for (std::size_t id = 0; id < kInFlight && stream.next < stream.count; ++id, ++stream.next) {
    start<kKinds>(stream.rays[stream.next], stream.next, searches[id]);
    now->at_node[now->node_count++] = static_cast<std::uint8_t>(id);
  }
  while (now->node_count + now->leaf_count != 0) {
    for (std::size_t i = 0; i < now->node_count; ++i) {
      Search& search = searches[now->at_node[i]];
      visit_node<kAnyHit>(bvh.nodes[search.current.node_index()], search);
    }
    for (std::size_t i = 0; i < now->leaf_count; ++i) {
      Search& search = searches[now->at_leaf[i]];
      intersect_leaf<kKinds>(search.ray, search.current.leaf_ref(), bvh.rows.data(),
                             InsideTree<kAnyHit>{bvh}, search.best);
      if (kAnyHit && search.best.prim != kNoPrim) clear(search.pending);
    }
    next->node_count = next->leaf_count = next->ended_count = 0;
    for (std::size_t i = 0; i < now->node_count; ++i) {
      advance<kAnyHit>(bvh, searches[now->at_node[i]], now->at_node[i], *next);
    }
    for (std::size_t i = 0; i < now->leaf_count; ++i) {
      advance<kAnyHit>(bvh, searches[now->at_leaf[i]], now->at_leaf[i], *next);
    }
    for (std::size_t i = 0; i < next->ended_count; ++i) {
      Search& search = searches[next->ended[i]];
      stream.finish(search.index, search.best);
      if (stream.next == stream.count) continue;
      start<kKinds>(stream.rays[stream.next], stream.next, search);
      ++stream.next;
      next->at_node[next->node_count++] = next->ended[i];
    }
    Worklists* const done = now;
    now = next;
    next = done;
  }
}

template <LeafKinds kKinds>
HWY_NOINLINE void trace_one_by_one(const WideView& bvh, const Ray* rays, std::size_t count,
                                   Hit* hits) {
  const auto finish = [hits](std::size_t i, const Hit& best) { hits[i] = finished(best); };
  trace_stream<kKinds, false>(bvh, Stream<decltype(finish)>{rays, count, 0, finish});
}
HWY_INLINE void trace_one_by_one(const WideView& bvh, const Ray* rays, std::size_t count,
                                 Hit* hits) {
  switch (bvh.kinds) {
    case LeafKinds::spheres:
      return trace_one_by_one<LeafKinds::spheres>(bvh, rays, count, hits);
    case LeafKinds::triangles:
      return trace_one_by_one<LeafKinds::triangles>(bvh, rays, count, hits);
    case LeafKinds::any:
      return trace_one_by_one<LeafKinds::any>(bvh, rays, count, hits);
  }
}

// Whether trying a packet is worth it: after each failure in a row, twice as many are let pass.
struct Patience {
  std::size_t failures = 0, to_skip = 0;

  HWY_INLINE bool try_now() {
    if (to_skip == 0) return true;
    --to_skip;
    return false;
  }
  HWY_INLINE void learn(bool worked) {
    failures = worked ? 0 : failures + (failures < 6);
    to_skip = (std::size_t{1} << failures) - 1;
  }
};

// Packets where they work; what lies between them is traced in longer runs of single rays.
HWY_ATTR void intersect_wide(const WideView& bvh, const Ray* rays, Hit* hits, std::size_t count) {
  if (bvh.empty()) {
    for (std::size_t i = 0; i < count; ++i) hits[i] = Hit{};
    return;
  }
  PacketSearch search;
  Patience patience;
  std::size_t traced = 0;
  for (std::size_t i = 0; i + kPacketSize <= count; i += kPacketSize) {
    if (!patience.try_now()) continue;
    const bool worked = trace_packet(bvh, rays + i, search, hits + i);
    patience.learn(worked);
    if (!worked) continue;
    trace_one_by_one(bvh, rays + traced, i - traced, hits + traced);
    traced = i + kPacketSize;
  }
  trace_one_by_one(bvh, rays + traced, count - traced, hits + traced);
}

template <LeafKinds kKinds>
HWY_NOINLINE void occluded_one_by_one(const WideView& bvh, const Ray* rays, std::uint8_t* occluded,
                                      std::size_t count) {
  const auto finish = [occluded](std::size_t i, const Hit& best) {
    occluded[i] = best.prim != kNoPrim ? 1 : 0;
  };
  trace_stream<kKinds, true>(bvh, Stream<decltype(finish)>{rays, count, 0, finish});
}

HWY_ATTR void occluded_wide(const WideView& bvh, const Ray* rays, std::uint8_t* occluded,
                            std::size_t count) {
  if (bvh.empty()) {
    for (std::size_t i = 0; i < count; ++i) occluded[i] = 0;
    return;
  }
  switch (bvh.kinds) {
    case LeafKinds::spheres:
      return occluded_one_by_one<LeafKinds::spheres>(bvh, rays, occluded, count);
    case LeafKinds::triangles:
      return occluded_one_by_one<LeafKinds::triangles>(bvh, rays, occluded, count);
    case LeafKinds::any:
      return occluded_one_by_one<LeafKinds::any>(bvh, rays, occluded, count);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
