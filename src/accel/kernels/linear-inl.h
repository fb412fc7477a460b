// Brute force: each ray against every leaf.
#include "accel/kernels/dispatch.h"
#include "accel/kernels/leaf-inl.h"

#if defined(DAPPLE_KERNELS_LINEAR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_LINEAR_INL_H
#undef DAPPLE_KERNELS_LINEAR_INL_H
#else
#define DAPPLE_KERNELS_LINEAR_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct InsideLinear {
  const LinearView& view;

  HWY_INLINE const PlacedInstance& instance(PrimId id) const {
    return view.instances[id - view.first_id];
  }

  HWY_INLINE void find(const PreparedRay& ray, PrimId id, float entry, Hit& best) const {
    const PlacedInstance& placed = instance(id);
    if (placed.content == PlacedInstance::kNothing) return;
    const PreparedRay within = enter_instance(placed, ray);
    Hit inside = nothing_before(within.t_max < best.t ? within.t_max : best.t);
    const std::span<const LeafRef> leaves = view.prototypes[placed.content];
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      intersect_leaf<LeafKinds::triangles>(within, leaves[i], LeafArrays{view.rows},
                                           NothingInside(), inside);
    }
    keep_seen_through(id - view.first_id, entry, inside, best);
  }

  HWY_INLINE bool occludes(const PreparedRay& ray, PrimId id) const {
    const PlacedInstance& placed = instance(id);
    if (placed.content == PlacedInstance::kNothing) return false;
    const PreparedRay within = enter_instance(placed, ray);
    const std::span<const LeafRef> leaves = view.prototypes[placed.content];
    bool occluded = false;
    for (std::size_t i = 0; i < leaves.size() && !occluded; ++i) {
      occluded = leaf_occludes<LeafKinds::triangles>(within, leaves[i], LeafArrays{view.rows},
                                                     NothingInside());
    }
    return occluded;
  }
};

template <LeafKinds kKinds>
HWY_INLINE void intersect_all(const LinearView& view, const Ray* rays, Hit* hits,
                              std::size_t count) {
  for (std::size_t r = 0; r < count; ++r) {
    const PreparedRay ray = prepare(rays[r]);
    Hit best = nothing_before(ray.t_max);
    for (std::size_t i = 0; i < view.leaves.size(); ++i) {
      intersect_leaf<kKinds>(ray, view.leaves[i], LeafArrays{view.rows}, InsideLinear{view}, best);
    }
    hits[r] = finished(best);
  }
}

template <LeafKinds kKinds>
HWY_INLINE void occluded_by_any(const LinearView& view, const Ray* rays, std::uint8_t* occluded,
                                std::size_t count) {
  for (std::size_t r = 0; r < count; ++r) {
    const PreparedRay ray = prepare(rays[r]);
    bool found = false;
    for (std::size_t i = 0; i < view.leaves.size() && !found; ++i) {
      found = leaf_occludes<kKinds>(ray, view.leaves[i], LeafArrays{view.rows}, InsideLinear{view});
    }
    occluded[r] = found ? 1 : 0;
  }
}

HWY_ATTR void intersect_linear(const LinearView& view, const Ray* rays, Hit* hits,
                               std::size_t count) {
  switch (view.kinds) {
    case LeafKinds::spheres:
      return intersect_all<LeafKinds::spheres>(view, rays, hits, count);
    case LeafKinds::triangles:
      return intersect_all<LeafKinds::triangles>(view, rays, hits, count);
    default:
      return intersect_all<LeafKinds::any>(view, rays, hits, count);
  }
}

HWY_ATTR void occluded_linear(const LinearView& view, const Ray* rays, std::uint8_t* occluded,
                              std::size_t count) {
  switch (view.kinds) {
    case LeafKinds::spheres:
      return occluded_by_any<LeafKinds::spheres>(view, rays, occluded, count);
    case LeafKinds::triangles:
      return occluded_by_any<LeafKinds::triangles>(view, rays, occluded, count);
    default:
      return occluded_by_any<LeafKinds::any>(view, rays, occluded, count);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
