// Rays traced one by one, many in flight.
//
// A thread steps many searches in turn, first those whose next visit is a node, then those whose
// next visit is a leaf. So the memory that one search waits for arrives while others work, and
// almost nothing is left that a branch predictor could get wrong: which lanes were hit is data,
// never control flow.
#include "accel/kernels/dispatch.h"
#include "accel/kernels/packet-inl.h"
#include "accel/kernels/passed-inl.h"
#include "accel/kernels/search-inl.h"

#if defined(DAPPLE_KERNELS_SINGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_SINGLES_INL_H
#undef DAPPLE_KERNELS_SINGLES_INL_H
#else
#define DAPPLE_KERNELS_SINGLES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

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
inline constexpr std::size_t kChunk = 8192;

// Rays of a job that are traced one by one: runs of kBatch, the last of which may be shorter.
struct Singles {
  std::uint16_t runs[kChunk / kBatch];  // the first ray of each
  std::size_t run_count = 0, count = 0;

  HWY_INLINE void add(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; i += kBatch)
      runs[run_count++] = static_cast<std::uint16_t>(i);
    count += end - begin;
  }
  HWY_INLINE void drop_first(std::size_t runs_done) {
    if (runs_done == 0) return;
    run_count -= runs_done;
    count -= runs_done * kBatch;
    for (std::size_t i = 0; i < run_count; ++i) runs[i] = runs[i + runs_done];
  }
};

// Starts them in turn, prepared a run at a time.
template <LeafKinds kKinds>
class Starter {
 public:
  HWY_INLINE Starter(const Ray* rays, const Singles& singles) : rays_(rays), singles_(singles) {}

  HWY_INLINE bool any_left() const { return next_ < singles_.count; }
  HWY_INLINE void start_next(Search& search) {
    const std::size_t place = next_ % kBatch, first = singles_.runs[next_ / kBatch];
    if (place == 0) prepare_run(first);
    start(batch_, place, first + place, search);
    ++next_;
  }

 private:
  HWY_INLINE void prepare_run(std::size_t first) {
    constexpr bool kFrame = kKinds != LeafKinds::spheres;
    const std::size_t left = singles_.count - next_;
    if (HWY_LIKELY(left >= kBatch)) {
      const Ray* rays = rays_ + first;
      for (std::size_t i = 0; i < kBatch; i += 2) __builtin_prefetch(rays + kBatch + i);
      prepare_batch<kFrame>(rays, batch_);
      return;
    }
    Ray last[kBatch];
    for (std::size_t i = 0; i < kBatch; ++i) last[i] = rays_[first + (i < left ? i : 0)];
    prepare_batch<kFrame>(last, batch_);
  }

  const Ray* rays_;
  const Singles& singles_;
  std::size_t next_ = 0;
  RayBatch batch_;
};

// The rows of these leaves have been asked for, and should be here by now.
HWY_INLINE void prefetch_positions(const WideView& bvh, const Search* searches,
                                   const Worklists& lists) {
  for (std::size_t i = 0; i < lists.leaf_count; ++i) {
    const ChildRef leaf = searches[lists.at_leaf[i]].current;
    if (leaf.leaf_kind() != ShapeKind::triangle) continue;
    prefetch_positions(bvh.rows.data() + leaf.leaf_row(), bvh.positions.data());
  }
}

// Where the numbers of the leaves stand that searches visit: in the tree ...
template <LeafKinds kKinds>
struct VisitedLeaves {
  const LeafRow* rows;

  HWY_INLINE explicit VisitedLeaves(const WideView& bvh) : rows(bvh.rows.data()) {}
  HWY_INLINE const LeafRow* first(const Search& search, std::size_t) { return again(search, 0); }
  HWY_INLINE const LeafRow* again(const Search& search, std::size_t) const {
    return rows + search.current.leaf_row();
  }
};

// ... or here, after they were made whole.
template <>
struct VisitedLeaves<LeafKinds::compact_triangles> {
  const LeafArrays leaves;
  WholeTriangles whole[kInFlight];

  HWY_INLINE explicit VisitedLeaves(const WideView& bvh) : leaves(bvh.leaves()) {}
  HWY_INLINE const LeafRow* first(const Search& search, std::size_t id) {
    make_whole(leaves.rows + search.current.leaf_row(), leaves, whole[id]);
    return whole[id].rows;
  }
  HWY_INLINE const LeafRow* again(const Search&, std::size_t id) const { return whole[id].rows; }
};

template <LeafKinds kKinds, bool kAnyHit>
HWY_INLINE void visit_leaves(const WideView& bvh, const Worklists& lists, Search* searches) {
  if constexpr (kAnyKinds<kKinds>) {
    for (std::size_t i = 0; i < lists.leaf_count; ++i) {
      Search& search = searches[lists.at_leaf[i]];
      intersect_leaf<kKinds>(search.ray, search.current.leaf_ref(), leaves_of<kKinds>(bvh),
                             InsideTree<kAnyHit, kKinds>{bvh}, search.best);
      if (kAnyHit && search.best.prim != kNoPrim) clear(search.pending);
    }
  } else {
    VisitedLeaves<kKinds> leaves(bvh);
    Passed passed[kInFlight * kVecsOfLeaf + 1];
    std::size_t count = 0;
    for (std::size_t i = 0; i < lists.leaf_count; ++i) {
      const std::size_t id = lists.at_leaf[i];
      const LeafRow* leaf = leaves.first(searches[id], id);
      count += pass_leaf<kKinds>(searches[id], id, leaf, passed + count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t id = passed[i].search;
      finish_leaf<kKinds, kAnyHit>(passed[i], leaves.again(searches[id], id), searches[id]);
    }
  }
}

template <LeafKinds kKinds, class Job>
HWY_NOINLINE void trace_singles(const WideView& bvh, const Job& job, const Singles& singles) {
  constexpr bool kAnyHit = Job::kAnyHit;
  Search searches[kInFlight];
  Worklists both[2];
  Worklists *now = &both[0], *next = &both[1];
  Starter<kKinds> starter(job.rays, singles);
  for (Search& search : searches) make_bottom(search.pending);
  for (std::size_t id = 0; id < kInFlight && starter.any_left(); ++id) {
    starter.start_next(searches[id]);
    now->at_node[now->node_count++] = static_cast<std::uint8_t>(id);
  }
  while (now->node_count + now->leaf_count != 0) {
    if constexpr (is_compact(kKinds)) {
      if (bvh.far) prefetch_positions(bvh, searches, *now);
    }
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
      if (!starter.any_left()) continue;
      starter.start_next(search);
      next->at_node[next->node_count++] = next->ended[i];
    }
    Worklists* const done = now;
    now = next;
    next = done;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
