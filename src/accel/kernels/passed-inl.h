// Leaves in two steps: what of them the lines of many rays pass, then where those rays meet it.
//
// Whether a ray passes anything in a leaf would be predicted wrongly half the time, and all that
// was begun for the next leaf would be lost each time. So the first step, without a branch, makes a
// list for the second.
#include "accel/kernels/search-inl.h"

#if defined(DAPPLE_KERNELS_PASSED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PASSED_INL_H
#undef DAPPLE_KERNELS_PASSED_INL_H
#else
#define DAPPLE_KERNELS_PASSED_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Lanes [first, first + kLanes) of the leaf that a search visits.
struct alignas(64) Passed {
  float numbers[3][kLanes];
  FloatMask mask;
  std::uint8_t search, first;
};

inline constexpr std::size_t kVecsOfLeaf = kLeafWidth / kLanes;

HWY_INLINE void save(const PassedSpheres& spheres, Passed& passed) {
  hn::Store(spheres.t_mid, Floats(), passed.numbers[0]);
  hn::Store(spheres.discriminant, Floats(), passed.numbers[1]);
  passed.mask = spheres.mask;
}
HWY_INLINE void save(const PassedTriangles& triangles, Passed& passed) {
  for (int i = 0; i < 3; ++i) hn::Store(triangles.weights[i], Floats(), passed.numbers[i]);
  passed.mask = triangles.mask;
}

// Writes what search `id` passes in its leaf, whose numbers are there, at most kVecsOfLeaf entries,
// of which it returns the number; the entry behind them is written too.
template <LeafKinds kKinds>
HWY_INLINE std::size_t pass_leaf(const Search& search, std::size_t id, const LeafRow* leaf,
                                 Passed* out) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
    Passed& passed = out[count];
    if constexpr (kKinds == LeafKinds::spheres) {
      save(pass_spheres(search.ray, leaf, i), passed);
    } else {
      save(pass_triangles(search.ray, leaf, i), passed);
    }
    passed.search = static_cast<std::uint8_t>(id);
    passed.first = static_cast<std::uint8_t>(i);
    count += any(passed.mask);
  }
  return count;
}

template <LeafKinds kKinds>
HWY_INLINE LaneHits enter_passed(const Passed& passed, const PreparedRay& ray, const LeafRow* leaf,
                                 float t_best) {
  const std::size_t i = passed.first;
  if constexpr (kKinds == LeafKinds::spheres) {
    const PassedSpheres spheres = {passed.mask, load_floats(passed.numbers[0]),
                                   load_floats(passed.numbers[1])};
    return enter_spheres(ray, leaf, i, spheres, t_best);
  } else {
    PassedTriangles triangles = {passed.mask, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      triangles.weights[k] = load_floats(passed.numbers[k]);
      triangles.z[k] = hn::Sub(load_row(leaf, 3 * k + ray.axis, i), all(ray.origin[ray.axis]));
    }
    return enter_triangles(ray, leaf, i, triangles, t_best);
  }
}

// The second step, which keeps the nearest hit, or for any hit that there is one and ends there.
template <LeafKinds kKinds, bool kAnyHit>
HWY_INLINE void finish_leaf(const Passed& passed, const LeafRow* begin, Search& search) {
  const LeafRef leaf = search.current.leaf_ref();
  const LaneHits hits = enter_passed<kKinds>(passed, search.ray, begin, search.best.t);
  const bool found = any(hits.mask);
  if (kAnyHit) {
    search.best.prim = found ? 0 : search.best.prim;
    search.pending.top = found ? kStackBottom : search.pending.top;
  } else if (found) {
    keep_best(hits, leaf, begin, passed.first, search.best);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
