// Streams: thousands of rays that need not go the same way visit a tree of spheres together.
//
// All rays that enter a node are tested with one child after the other, a ray a lane [GribbleR08],
// and each child gets the list of those that enter it. So no ray has a stack or sorts
// anything: rays of one octant of directions meet children in the order of that octant. As long as
// the lists are long this takes half the time of tracing rays one by one; where they are short, as
// in large clouds, more. Boxes are tested a little too large, which changes no hit: primitives have
// the last word.
#include "accel/kernels/stream_spheres-inl.h"

#if defined(DAPPLE_KERNELS_STREAM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_STREAM_INL_H
#undef DAPPLE_KERNELS_STREAM_INL_H
#else
#define DAPPLE_KERNELS_STREAM_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// kLanes of the rays that meet a node: a plane at p is met at p * inverse + add, where what is
// added is a little less for planes that are entered and a little more for those that are left.
struct NodeRays {
  float inverse[3][kLanes], near_add[3][kLanes], far_add[3][kLanes];
  float t_min[kLanes], t_best[kLanes];
};
static_assert(sizeof(NodeRays) * (kNodePiece / kLanes) == sizeof(StreamScratch::node_rays));

// Many times the rounding of o * inverse, and of what is added to it.
inline constexpr float kCrossingSlack = 0x1p-21f;
// The same of a distance.
inline constexpr float kEntryShrink = 1.0f - 0x1p-20f;

// Leaves that so many rays meet, in the mean, make it worth it; known after some visits.
inline constexpr std::size_t kWorthwhileList = 5;
inline constexpr std::size_t kLeavesOnTrial = 128;

// For ordering, what is farther is as far.
inline constexpr float kFarthest = 1e37f;

// A walk through the tree with rays of one octant.
template <bool kAnyHit>
class StreamWalk {
 public:
  HWY_INLINE StreamWalk(const WideView& bvh, StreamScratch& scratch) : bvh_(bvh), s_(scratch) {}

  // False if that is better done otherwise; what was found so far need not be all.
  HWY_INLINE bool trace(std::uint32_t octant) {
    RayList list = {s_.octants[octant], s_.octant_counts[octant]};
    s_.octant_counts[octant] = 0;
    list.pad();
    octant_ = octant;
    return list.count == 0 || visit(0, list, 0);
  }

 private:
  struct Children {
    std::size_t count;
    std::uint8_t order[kWideWidth];  // from near to far along the octant's diagonal
  };

  HWY_INLINE Children children_of(const WideNode& node) const {
    const Floats d;
    const NodePlanes& planes = kPlanesBySigns.of[octant_];
    alignas(64) float near[kWideWidth];
    for (std::size_t i = 0; i < kWideWidth; i += kLanes) {
      FloatVec sum = hn::Zero(d);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float sign = (octant_ >> axis & 1) != 0 ? -1.0f : 1.0f;
        const FloatVec plane = load_floats(&node.lo[0][0] + planes.near[axis] + i);
        // Without infinities, the sum of which would be no number and have no place.
        const FloatVec finite = hn::Min(hn::Max(plane, all(-kFarthest)), all(kFarthest));
        sum = hn::MulAdd(all(sign), finite, sum);
      }
      hn::Store(sum, d, near + i);
    }
    Children children = {};
    while (children.count < kWideWidth && !node.children[children.count].empty()) ++children.count;
    for (std::size_t i = 0; i < children.count; ++i) {
      std::uint32_t before = 0, same = 0;
      for (std::size_t k = 0; k < kWideWidth; k += kLanes) {
        before |= bits_of(hn::Lt(load_floats(near + k), all(near[i]))) << k;
        same |= bits_of(hn::Eq(load_floats(near + k), all(near[i]))) << k;
      }
      const std::uint32_t rank_bits = before | (same & ((1u << i) - 1));
      children.order[__builtin_popcount(rank_bits)] = static_cast<std::uint8_t>(i);
    }
    return children;
  }

  HWY_INLINE NodeRays* node_rays() const { return reinterpret_cast<NodeRays*>(s_.node_rays); }

  HWY_INLINE void prepare(const RayList& list) {
    const Floats d;
    for (std::size_t i = 0; i < list.count; i += kLanes) {
      const Quads origin = load_quads(s_.origin, list.rays + i);
      const Quads inverse = load_quads(s_.inverse, list.rays + i);
      NodeRays& rays = node_rays()[i / kLanes];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const FloatVec crossing = hn::Mul(origin.of[axis], inverse.of[axis]);
        const FloatVec slack = hn::Mul(hn::Abs(crossing), all(kCrossingSlack));
        hn::Store(inverse.of[axis], d, rays.inverse[axis]);
        hn::Store(hn::Neg(hn::Add(crossing, slack)), d, rays.near_add[axis]);
        hn::Store(hn::Sub(slack, crossing), d, rays.far_add[axis]);
      }
      hn::Store(origin.of[3], d, rays.t_min);
      hn::Store(hn::IfThenElse(list.there(i), inverse.of[3], all(-1.0f)), d, rays.t_best);
    }
  }

  // Lists those of the prepared rays that enter a child's box, with their distances to it.
  HWY_INLINE void enter(const WideNode& node, std::size_t child, const RayList& list,
                        RayList& entered) const {
    const NodePlanes& planes = kPlanesBySigns.of[octant_];
    FloatVec near[3], far[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      near[axis] = all((&node.lo[0][0])[planes.near[axis] + child]);
      far[axis] = all((&node.lo[0][0])[planes.far[axis] + child]);
    }
    const NodeRays* rays = node_rays();
    for (std::size_t i = 0; i < list.count; i += kLanes, ++rays) {
      FloatVec in[3], out[3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const FloatVec inverse = load_floats(rays->inverse[axis]);
        in[axis] = hn::MulAdd(near[axis], inverse, load_floats(rays->near_add[axis]));
        out[axis] = hn::MulAdd(far[axis], inverse, load_floats(rays->far_add[axis]));
      }
      const FloatVec t_min = load_floats(rays->t_min), t_best = load_floats(rays->t_best);
      // A number that is not one stands first, and is passed over.
      const FloatVec last = hn::Max(hn::Max(in[0], in[1]), hn::Max(in[2], t_min));
      const FloatVec entry = hn::Mul(last, all(kEntryShrink));
      const FloatVec exit = hn::Min(hn::Min(out[0], out[1]), hn::Min(out[2], t_best));
      entered.append(with_distances(hn::LoadU(Words(), list.rays + i), entry), hn::Le(entry, exit));
    }
  }

  HWY_INLINE bool worth_it(const RayList& at_leaf) {
    ++leaf_visits_;
    rays_at_leaves_ += at_leaf.count;
    return leaf_visits_ < kLeavesOnTrial || rays_at_leaves_ >= kWorthwhileList * leaf_visits_;
  }

  // Lists of children are kept from `begin` of the scratch memory on.
  HWY_NOINLINE bool visit(std::size_t number, const RayList& list, std::size_t begin) {
    const WideNode& node = bvh_.nodes[number];
    const Children children = children_of(node);
    if (children.count == 0) return true;
    constexpr std::size_t kRoom = sizeof s_.lists / sizeof s_.lists[0];
    const std::size_t room = (kRoom - begin) / children.count;
    if (room < 2 * kListPadding) return false;
    const std::size_t most = room - kListPadding < kNodePiece ? room - kListPadding : kNodePiece;
    for (std::size_t i = 0; i < list.count; i += most) {
      const std::size_t left = list.count - i;
      if (!visit_piece(node, children, {list.rays + i, left < most ? left : most}, begin)) {
        return false;
      }
    }
    return true;
  }

  HWY_INLINE bool visit_piece(const WideNode& node, const Children& children, const RayList& list,
                              std::size_t begin) {
    prepare(list);
    RayList lists[kWideWidth];
    std::size_t end = begin;
    for (std::size_t i = 0; i < children.count; ++i) {
      lists[i] = {s_.lists + end};
      enter(node, children.order[i], list, lists[i]);
      end += lists[i].count == 0 ? 0 : lists[i].count + kListPadding;
    }
    for (std::size_t i = 0; i < children.count; ++i) {
      if (lists[i].count == 0) continue;
      drop_settled(s_, lists[i]);
      if (lists[i].count == 0) continue;
      if (!visit_child(node.children[children.order[i]], lists[i], end)) return false;
    }
    return true;
  }

  HWY_INLINE bool visit_child(ChildRef child, const RayList& list, std::size_t begin) {
    if (!child.is_leaf()) return visit(child.node_index(), list, begin);
    visit_spheres<kAnyHit>(bvh_.rows.data() + child.leaf_row(), child, list, s_);
    return worth_it(list);
  }

  const WideView& bvh_;
  StreamScratch& s_;
  std::uint32_t octant_ = 0;
  std::size_t leaf_visits_ = 0, rays_at_leaves_ = 0;
};

// What was found for rays [first, first + kBatch), for the job's from `to` on.
HWY_INLINE void report(const StreamScratch& s, std::size_t first, const ClosestHits& job,
                       std::size_t to) {
  const Words d;
  for (std::size_t i = 0; i < kBatch; i += kLanes) {
    WordVec prim, t;
    hn::LoadInterleaved2(d, reinterpret_cast<const std::uint32_t*>(s.best + first + i), prim, t);
    store_hits(floats_of_bits(t), prim, hn::Load(d, s.lane + first + i), hn::Zero(d),
               job.hits + to + i);
  }
}
HWY_INLINE void report(const StreamScratch& s, std::size_t first, const AnyHits& job,
                       std::size_t to) {
  for (std::size_t i = 0; i < kBatch; ++i) {
    job.occluded[to + i] = static_cast<std::uint32_t>(s.best[first + i]) != kNoPrim ? 1 : 0;
  }
}

// Traces `count` runs of kBatch rays each; false, and nothing is written, if that is better done
// otherwise.
template <class Job>
HWY_INLINE bool trace_runs(const WideView& bvh, const Job& job, const std::uint16_t* runs,
                           std::size_t count, StreamScratch& s) {
  StreamWalk<Job::kAnyHit> walk(bvh, s);
  for (std::uint32_t& octant : s.octant_counts) octant = 0;
  for (std::size_t i = 0; i < count; ++i) {
    add_to_stream(job.rays + runs[i], i * kBatch, s);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const bool full = s.octant_counts[octant] + kBatch > kNodePiece;
      if (full && !walk.trace(octant)) return false;
    }
  }
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    if (!walk.trace(octant)) return false;
  }
  for (std::size_t i = 0; i < count; ++i) report(s, i * kBatch, job, runs[i]);
  return true;
}

// Removes from `singles` the rays that it traces.
template <class Job>
HWY_NOINLINE void trace_streams(const WideView& bvh, const Job& job, Singles& singles) {
  constexpr std::size_t kMostRuns = kStreamRays / kBatch;
  const std::size_t whole_runs = singles.count / kBatch;
  StreamScratch* scratch = whole_runs * kBatch < kSmallestStream ? nullptr : stream_scratch();
  if (scratch == nullptr) return;
  std::size_t done = 0;
  while (done < whole_runs) {
    const std::size_t left = whole_runs - done;
    const std::size_t count = left < kMostRuns ? left : kMostRuns;
    if (!scratch->patience.try_now(bvh.nodes.data(), count * kBatch)) break;
    if (!trace_runs(bvh, job, singles.runs + done, count, *scratch)) {
      scratch->patience.failed(count * kBatch);
      break;
    }
    done += count;
  }
  singles.drop_first(done);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
