// Packets: rays that go the same way visit the tree together.
//
// A node is tested once for the whole packet, by intervals [WaldBS07]: the packet's origins lie in
// a box and its inverse directions, which have the same signs, in another. Rounding is monotone, so
// the interval computed from the ends of both contains what each ray would compute, to the bit: no
// child that a ray passes is left out. In a leaf the same test on the primitives' own boxes leaves
// few of them, and each of those is tested against all rays at once.
#include "accel/kernels/packet_leaf-inl.h"

#if defined(DAPPLE_KERNELS_PACKET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PACKET_INL_H
#undef DAPPLE_KERNELS_PACKET_INL_H
#else
#define DAPPLE_KERNELS_PACKET_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

HWY_INLINE void visit_node(const PacketBounds& bounds, const WideNode& node,
                           PendingStack& pending) {
  LaneHits hits[kNodeVecs];
  for (std::size_t i = 0; i < kNodeVecs; ++i) {
    FloatVec lo[3], hi[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lo[axis] = load_floats(node.lo[axis] + i * kLanes);
      hi[axis] = load_floats(node.hi[axis] + i * kLanes);
    }
    hits[i] = enter_boxes(bounds, lo, hi);
  }
  push_children(hits, node.children, pending);
}

HWY_INLINE void prefetch_pushed(const WideView& bvh, const PendingStack& pending,
                                std::size_t before) {
  for (std::size_t i = pending.top; i > before; --i) {
    prefetch(bvh, ChildRef(pending.children[i - 1]));
  }
}

// The hits of all rays of a packet, as the four words that each is in memory.
template <class Packet>
HWY_INLINE void write_hits(const Packet& packet, Hit* hits) {
  const Words d;
  for (std::size_t i = 0; i < Packet::kRays; i += kLanes) {
    const WordVec prim = hn::Load(d, packet.best_prim + i);
    const WordVec leaf = hn::Load(d, packet.best_leaf + i);
    const WordVec lane = hn::Or(hn::ShiftLeft<4>(leaf), hn::Load(d, packet.best_lane + i));
    const WordVec kind = hn::ShiftLeft<28>(hn::And(hn::ShiftRight<28>(leaf), hn::Set(d, 7)));
    store_hits(load_floats(packet.best_t + i), prim, lane, kind, hits + i);
  }
}

template <std::size_t kSize>
struct PacketSearch {
  Packet<kSize> packet;
  PacketBounds bounds;
  PendingStack pending;

  PacketSearch() { make_bottom(pending); }
};

// Finds what the rays of a packet hit; false when they are better traced one by one.
template <LeafKinds kKinds, bool kAnyHit, std::size_t kSize>
HWY_NOINLINE bool search_packet(const WideView& bvh, const Ray* rays, PacketSearch<kSize>& search) {
  auto& [packet, bounds, pending] = search;
  fill<kKinds>(rays, packet, bounds);
  if (!bound(packet, bounds)) return false;
  clear(pending);
  int work = 0;
  for (ChildRef current = ChildRef::node(0); !current.empty();
       current = pop_nearest(pending, bounds.t_best)) {
    if (work > kBudget<kKinds, kSize>) return false;
    if (current.is_leaf()) {
      const ShapeKind kind = current.leaf_kind();
      if (kKinds == LeafKinds::any && kind > ShapeKind::triangle) return false;  // not for packets
      if (kind == ShapeKind::triangle && !bounds.one_axis) return false;
      work += kNodeWork + visit_leaf<kKinds, kAnyHit>(bounds, current, bvh.leaves(), packet);
      bounds.t_best = extent_of(packet.best_t).high;
    } else {
      work += kNodeWork;
      const std::size_t before = pending.top;
      visit_node(bounds, bvh.nodes[current.node_index()], pending);
      // A packet visits most of what it pushes. Of spheres, whose leaves take it longer, it is
      // faster not to ask.
      if (bvh.far && kKinds == LeafKinds::triangles) prefetch_pushed(bvh, pending, before);
    }
  }
  return true;
}

// What to do with rays: find their closest hits ...
struct ClosestHits {
  static constexpr bool kAnyHit = false;
  const Ray* rays;
  Hit* hits;

  HWY_INLINE void set(std::size_t i, const Hit& best) const { hits[i] = finished(best); }
  template <class Packet>
  HWY_INLINE void set_all(std::size_t begin, const Packet& packet) const {
    write_hits(packet, hits + begin);
  }
};

// ... or whether they hit anything.
struct AnyHits {
  static constexpr bool kAnyHit = true;
  const Ray* rays;
  std::uint8_t* occluded;

  HWY_INLINE void set(std::size_t i, const Hit& best) const {
    occluded[i] = best.prim != kNoPrim ? 1 : 0;
  }
  template <class Packet>
  HWY_INLINE void set_all(std::size_t begin, const Packet& packet) const {
    for (std::size_t i = 0; i < Packet::kRays; ++i) {
      occluded[begin + i] = packet.best_prim[i] != kNoPrim ? 1 : 0;
    }
  }
};

// Traces rays [begin, begin + kSize) of a job; false, and nothing is written, when they are better
// traced otherwise.
template <LeafKinds kKinds, class Job, std::size_t kSize>
HWY_INLINE bool trace_packet(const WideView& bvh, const Job& job, std::size_t begin,
                             PacketSearch<kSize>& search) {
  if (!search_packet<kKinds, Job::kAnyHit>(bvh, job.rays + begin, search)) return false;
  job.set_all(begin, search.packet);
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
