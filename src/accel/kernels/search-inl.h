// One ray's way through the wide BVH: its state, a visit of a node, what is next.
#include "accel/kernels/leaf-inl.h"
#include "accel/kernels/prepare-inl.h"
#include "accel/kernels/push-inl.h"

#if defined(DAPPLE_KERNELS_SEARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_SEARCH_INL_H
#undef DAPPLE_KERNELS_SEARCH_INL_H
#else
#define DAPPLE_KERNELS_SEARCH_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Which planes of a node's boxes a ray meets first depends on the signs of its direction.
struct NodePlanes {
  std::uint32_t near[3], far[3];  // float offsets in a node
};

// For each combination of signs: bit i is set where the ray goes down along axis i.
struct PlanesBySigns {
  NodePlanes of[8];

  constexpr PlanesBySigns() : of{} {
    for (std::uint32_t signs = 0; signs < 8; ++signs) {
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const bool down = (signs >> axis & 1) != 0;
        of[signs].near[axis] = (axis + (down ? 3 : 0)) * kWideWidth;
        of[signs].far[axis] = (axis + (down ? 0 : 3)) * kWideWidth;
      }
    }
  }
};
inline constexpr PlanesBySigns kPlanesBySigns;

// Bit i is set where the ray goes down along axis i; the inverse direction is never zero.
HWY_INLINE std::uint32_t signs_of(const PreparedRay& ray) {
  std::uint32_t bits[3];
  __builtin_memcpy(bits, ray.inverse, sizeof bits);
  return bits[0] >> 31 | bits[1] >> 31 << 1 | bits[2] >> 31 << 2;
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

template <bool kAnyHit>
HWY_INLINE void visit_node(const WideNode& node, Search& search) {
  LaneHits hits[kNodeVecs];
  for (std::size_t i = 0; i < kNodeVecs; ++i) hits[i] = enter_boxes(search, node, i * kLanes);
  if (kAnyHit) {
    push_children_unordered(hits, node.children, search.pending);
  } else {
    push_children(hits, node.children, search.pending);
  }
}

template <bool kAnyHit>
HWY_INLINE ChildRef pop(Search& search) {
  return kAnyHit ? pop_any(search.pending) : pop_nearest(search.pending, search.best.t);
}

// With ray `place` of a batch, number `index` of the stream.
HWY_INLINE void start(const RayBatch& batch, std::size_t place, std::size_t index, Search& search) {
  const std::uint32_t signs = take_ray(batch, place, search.ray);
  search.planes = kPlanesBySigns.of[signs];
  search.best = nothing_before(search.ray.t_max);
  search.index = index;
  search.current = ChildRef::node(0);
  clear(search.pending);
}

// What is needed to read leaves of these kinds.
template <LeafKinds kKinds>
HWY_INLINE LeafArrays leaves_of(const WideView& bvh) {
  if constexpr (is_compact(kKinds)) {
    return bvh.leaves();
  } else {
    return {bvh.rows.data()};
  }
}

// What a ray finds in the tree of an instance, if that is no farther than `t_best`: one search from
// beginning to end.
template <bool kAnyHit, LeafKinds kKinds>
HWY_NOINLINE Hit search_instance(const WideView& bvh, const PlacedInstance& instance,
                                 const PreparedRay& ray, float t_best) {
  Search search;
  search.ray = enter_instance(instance, ray);
  search.planes = kPlanesBySigns.of[signs_of(search.ray)];
  search.best = nothing_before(search.ray.t_max < t_best ? search.ray.t_max : t_best);
  make_bottom(search.pending);
  clear(search.pending);
  for (ChildRef current = ChildRef::node(instance.content); !current.empty();
       current = pop<kAnyHit>(search)) {
    if (!current.is_leaf()) {
      visit_node<kAnyHit>(bvh.nodes[current.node_index()], search);
      continue;
    }
    intersect_leaf<kKinds>(search.ray, current.leaf_ref(), leaves_of<kKinds>(bvh), NothingInside(),
                           search.best);
    if (kAnyHit && search.best.prim != kNoPrim) break;
  }
  return search.best;
}

// Prototypes hold triangles, in the form of the whole tree.
template <bool kAnyHit, LeafKinds kKinds>
struct InsideTree {
  static constexpr LeafKinds kInside =
      is_compact(kKinds) ? LeafKinds::compact_triangles : LeafKinds::triangles;
  const WideView& bvh;

  HWY_INLINE void find(const PreparedRay& ray, PrimId id, float entry, Hit& best) const {
    const std::size_t index = id - bvh.first_id;
    const PlacedInstance& instance = bvh.instances[index];
    if (instance.content == PlacedInstance::kNothing) return;
    if (kAnyHit && best.prim != kNoPrim) return;
    const Hit inside = search_instance<kAnyHit, kInside>(bvh, instance, ray, best.t);
    keep_seen_through(index, entry, inside, best);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
