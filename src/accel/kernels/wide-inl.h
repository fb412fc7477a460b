// Traversal of the wide BVH: many rays in flight, all children of a node at once.
//
// A thread steps many searches in turn, first those whose next visit is a node, then those whose
// next visit is a leaf. So the memory that one search waits for arrives while others work, and
// almost nothing is left that a branch predictor could get wrong: which lanes were hit is data,
// never control flow.
#include "accel/kernels/dispatch.h"
#include "accel/kernels/leaf-inl.h"
#include "accel/kernels/packet-inl.h"
#include "accel/kernels/stack-inl.h"

#if defined(DAPPLE_KERNELS_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_WIDE_INL_H
#undef DAPPLE_KERNELS_WIDE_INL_H
#else
#define DAPPLE_KERNELS_WIDE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Which planes of a node's boxes a ray meets first depends on the signs of its direction.
struct NodePlanes {
  std::uint32_t near[3], far[3];  // float offsets in a node
};

HWY_INLINE NodePlanes planes_of(const PreparedRay& ray) {
  NodePlanes planes;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const bool up = ray.inverse[axis] >= 0.0f;
    planes.near[axis] = (axis + (up ? 0 : 3)) * kWideWidth;
    planes.far[axis] = (axis + (up ? 3 : 0)) * kWideWidth;
  }
  return planes;
}

// A ray in flight.
struct Search {
  PreparedRay ray;
  NodePlanes planes;
  Hit best;
  ChildRef current;   // what is to be visited next
  std::size_t index;  // of the ray in the stream
  PendingStack pending;
};

// Lanes [i, i + kLanes) of a node: where the ray enters their boxes, and which it passes in time.
HWY_INLINE LaneHits enter_boxes(const Search& search, const WideNode& node, std::size_t i) {
  const PreparedRay& ray = search.ray;
  const float* floats = &node.lo[0][0] + i;
  const FloatVec nx = meet(load_floats(floats + search.planes.near[0]), ray, 0);
  const FloatVec ny = meet(load_floats(floats + search.planes.near[1]), ray, 1);
  const FloatVec nz = meet(load_floats(floats + search.planes.near[2]), ray, 2);
  const FloatVec fx = meet_far(load_floats(floats + search.planes.far[0]), ray, 0);
  const FloatVec fy = meet_far(load_floats(floats + search.planes.far[1]), ray, 1);
  const FloatVec fz = meet_far(load_floats(floats + search.planes.far[2]), ray, 2);
  const FloatVec entry = hn::Max(hn::Max(nx, ny), hn::Max(nz, all(ray.t_min)));
  const FloatVec exit = hn::Min(hn::Min(fx, fy), hn::Min(fz, all(search.best.t)));
  return {hn::Le(entry, exit), entry};
}

HWY_INLINE void visit_node(const WideNode& node, Search& search) {
  const std::size_t bottom = search.pending.top;
  for (std::size_t i = 0; i < kWideWidth; i += kLanes) {
    push_children(enter_boxes(search, node, i), node.children + i, bottom, search.pending);
  }
}

// Asks for the memory that visiting `child` will read: seven cache lines of a node, five or six of
// a leaf. Without branches, so some lines are asked for twice.
HWY_INLINE void prefetch(const WideBvhView& bvh, ChildRef child) {
  const bool is_leaf = child.is_leaf();
  const char* rows = reinterpret_cast<const char*>(bvh.rows.data()) + child.leaf_row() * 64;
  const char* nodes = reinterpret_cast<const char*>(bvh.nodes.data());
  const char* node = nodes + (child.is_node() ? child.node_index() * sizeof(WideNode) : 0);
  const char* begin = is_leaf ? rows : node;
  __builtin_prefetch(begin);
  __builtin_prefetch(begin + 64);
  __builtin_prefetch(begin + 128);
  __builtin_prefetch(begin + 192);
  __builtin_prefetch(begin + 256);
  const char* rest = begin + (is_leaf ? 0 : 320);
  __builtin_prefetch(rest);
  __builtin_prefetch(rest + 64);
}

// More hide more latency until their state no longer fits into the first-level cache.
inline constexpr std::size_t kInFlight = 24;

// The searches of a stream, in lists by what they do next.
struct Worklists {
  std::uint8_t at_node[kInFlight] = {}, at_leaf[kInFlight] = {}, ended[kInFlight] = {};
  std::size_t node_count = 0, leaf_count = 0, ended_count = 0;
};

// Files a search under what its stack says is next.
HWY_INLINE void advance(const WideBvhView& bvh, Search& search, std::size_t id, Worklists& lists) {
  search.current = pop_nearest(search.pending, search.best.t);
  const bool is_leaf = search.current.is_leaf(), is_node = search.current.is_node();
  lists.at_leaf[lists.leaf_count] = lists.at_node[lists.node_count] =
      lists.ended[lists.ended_count] = static_cast<std::uint8_t>(id);
  lists.leaf_count += is_leaf;
  lists.node_count += is_node;
  lists.ended_count += !is_leaf && !is_node;
  prefetch(bvh, search.current);
}

HWY_INLINE void start(const Ray& ray, std::size_t index, Search& search) {
  search.ray = prepare_fast(ray);
  search.planes = planes_of(search.ray);
  search.best = nothing_before(search.ray.t_max);
  search.index = index;
  search.current = ChildRef::node(0);
  clear(search.pending);
}

// What a ray finds in the tree of an instance, if that is no farther than `t_best`: one search from
// beginning to end.
template <bool kAnyHit>
HWY_NOINLINE Hit search_instance(const WideView& bvh, const PlacedInstance& instance,
                                 const PreparedRay& ray, float t_best) {
  Search search;
  search.ray = enter_instance(instance, ray);
  search.planes = planes_of(search.ray);
  search.best = nothing_before(search.ray.t_max < t_best ? search.ray.t_max : t_best);
  make_bottom(search.pending);
  clear(search.pending);
  for (ChildRef current = ChildRef::node(instance.content); !current.empty();
       current = pop_nearest(search.pending, search.best.t)) {
    if (!current.is_leaf()) {
      visit_node(bvh.nodes[current.node_index()], search);
      continue;
    }
    intersect_leaf(search.ray, current.leaf_ref(), bvh.rows.data(), NothingInside(), search.best);
    if (kAnyHit && search.best.prim != kNoPrim) break;
  }
  return search.best;
}

template <bool kAnyHit>
struct InsideTree {
  const WideView& bvh;

  HWY_INLINE void find(const PreparedRay& ray, PrimId id, float entry, Hit& best) const {
    const std::size_t index = id - bvh.first_id;
    const PlacedInstance& instance = bvh.instances[index];
    if (instance.content == PlacedInstance::kNothing) return;
    if (kAnyHit && best.prim != kNoPrim) return;
    keep_seen_through(index, entry, search_instance<kAnyHit>(bvh, instance, ray, best.t), best);
  }
};

// Rays of a stream still to be started, and what to do with a search that ended.
template <class Finish>
struct Stream {
  const Ray* rays;
  std::size_t count;
  std::size_t next;
  Finish finish;
};

template <bool kAnyHit, class Finish>
HWY_INLINE void trace_stream(const WideView& bvh, Stream<Finish> stream) {
  Search searches[kInFlight];
  Worklists lists;
  for (Search& search : searches) make_bottom(search.pending);
  for (std::size_t id = 0; id < kInFlight && stream.next < stream.count; ++id, ++stream.next) {
    start(stream.rays[stream.next], stream.next, searches[id]);
    lists.at_node[lists.node_count++] = static_cast<std::uint8_t>(id);
  }
  while (lists.node_count + lists.leaf_count != 0) {
    for (std::size_t i = 0; i < lists.node_count; ++i) {
      Search& search = searches[lists.at_node[i]];
      visit_node(bvh.nodes[search.current.node_index()], search);
    }
    for (std::size_t i = 0; i < lists.leaf_count; ++i) {
      Search& search = searches[lists.at_leaf[i]];
      intersect_leaf(search.ray, search.current.leaf_ref(), bvh.rows.data(),
                     InsideTree<kAnyHit>{bvh}, search.best);
      if (kAnyHit && search.best.prim != kNoPrim) clear(search.pending);
    }
    Worklists next;
    for (std::size_t i = 0; i < lists.node_count; ++i) {
      advance(bvh, searches[lists.at_node[i]], lists.at_node[i], next);
    }
    for (std::size_t i = 0; i < lists.leaf_count; ++i) {
      advance(bvh, searches[lists.at_leaf[i]], lists.at_leaf[i], next);
    }
    for (std::size_t i = 0; i < next.ended_count; ++i) {
      Search& search = searches[next.ended[i]];
      stream.finish(search.index, search.best);
      if (stream.next == stream.count) continue;
      start(stream.rays[stream.next], stream.next, search);
      ++stream.next;
      next.at_node[next.node_count++] = next.ended[i];
    }
    next.ended_count = 0;
    lists = next;
  }
}

HWY_NOINLINE void trace_one_by_one(const WideView& bvh, const Ray* rays, std::size_t count,
                                   Hit* hits) {
  const auto finish = [hits](std::size_t i, const Hit& best) { hits[i] = finished(best); };
  trace_stream<false>(bvh, Stream<decltype(finish)>{rays, count, 0, finish});
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

HWY_ATTR void occluded_wide(const WideView& bvh, const Ray* rays, std::uint8_t* occluded,
                            std::size_t count) {
  const auto finish = [occluded](std::size_t i, const Hit& best) {
    occluded[i] = best.prim != kNoPrim ? 1 : 0;
  };
  if (bvh.empty()) {
    for (std::size_t i = 0; i < count; ++i) occluded[i] = 0;
    return;
  }
  trace_stream<true>(bvh, Stream<decltype(finish)>{rays, count, 0, finish});
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
