// Whole leaves at once: the tests of intersect_scalar.h, operation for operation, on vectors.
#include "accel/hit.h"
#include "accel/intersect_cylinder.h"
#include "accel/kernels/compact_leaf-inl.h"
#include "accel/kernels/dispatch.h"
#include "accel/kernels/leaf_spheres-inl.h"
#include "accel/kernels/leaf_triangles-inl.h"
#include "accel/kernels/simd-inl.h"
#include "scene/leaf.h"

#if defined(DAPPLE_KERNELS_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_LEAF_INL_H
#undef DAPPLE_KERNELS_LEAF_INL_H
#else
#define DAPPLE_KERNELS_LEAF_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Rectangles [i, i + kLanes) of a leaf.
HWY_INLINE LaneHits intersect_rectangles(const PreparedRay& ray, RectangleAxes axes,
                                         const LeafRow* leaf, std::size_t i, float t_best) {
  const Floats d;
  const float k_direction = ray.direction[axes.k];
  const bool parallel = k_direction < kSmallestDirection && k_direction > -kSmallestDirection;
  if (parallel) return {hn::FirstN(d, 0), hn::Zero(d)};
  const bool u_up = ray.inverse[axes.u] >= 0.0f, v_up = ray.inverse[axes.v] >= 0.0f;
  const FloatVec u_near = meet(load_row(leaf, u_up ? 0 : 1, i), ray, axes.u);
  const FloatVec u_far = meet(load_row(leaf, u_up ? 1 : 0, i), ray, axes.u);
  const FloatVec v_near = meet(load_row(leaf, v_up ? 2 : 3, i), ray, axes.v);
  const FloatVec v_far = meet(load_row(leaf, v_up ? 3 : 2, i), ray, axes.v);
  const FloatVec t = meet(load_row(leaf, 4, i), ray, axes.k);
  const FloatVec near = hn::Max(hn::Max(u_near, v_near), all(ray.t_min));
  const FloatVec far = hn::Min(hn::Min(u_far, v_far), all(t_best));
  return {hn::And(hn::Ge(t, near), hn::Le(t, far)), t};
}

// Instances [i, i + kLanes) of a leaf: where the ray enters their boxes.
HWY_INLINE LaneHits enter_instance_boxes(const PreparedRay& ray, const LeafRow* leaf, std::size_t i,
                                         float t_best) {
  FloatVec near = all(ray.t_min), far = all(t_best);
  for (int axis = 0; axis < 3; ++axis) {
    const auto lo = static_cast<std::size_t>(axis), hi = lo + 3;
    const bool up = ray.inverse[axis] >= 0.0f;
    near = hn::Max(near, meet(load_row(leaf, up ? lo : hi, i), ray, axis));
    far = hn::Min(far, meet_far(load_row(leaf, up ? hi : lo, i), ray, axis));
  }
  return {hn::Le(near, far), near};
}

// Cylinders [i, i + kLanes) of a leaf, one by one.
HWY_INLINE LaneHits intersect_cylinders(const PreparedRay& ray, const LeafRow* leaf, std::size_t i,
                                        float t_best) {
  const Floats d;
  alignas(64) float t[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    float numbers[7];
    for (std::size_t row = 0; row < 7; ++row) numbers[row] = load_float(leaf[row].words + i + lane);
    const bool used = leaf[leaf_id_row(ShapeKind::cylinder)].words[i + lane] != kNoPrim;
    t[lane] = used ? intersect_cylinder(ray, numbers, t_best) : -1.0f;
  }
  const FloatVec hit = hn::Load(d, t);
  return {hn::Ge(hit, hn::Zero(d)), hit};
}

template <LeafKinds kKinds>
inline constexpr bool kTrianglesOnly =
    kKinds == LeafKinds::triangles || kKinds == LeafKinds::compact_triangles;
template <LeafKinds kKinds>
inline constexpr bool kAnyKinds = kKinds == LeafKinds::any || kKinds == LeafKinds::compact_any;

template <LeafKinds kKinds>
HWY_INLINE LaneHits intersect_lanes(const PreparedRay& ray, ShapeKind kind, const LeafRow* leaf,
                                    std::size_t i, float t_best) {
  if (kKinds == LeafKinds::spheres) return intersect_spheres(ray, leaf, i, t_best);
  if (kTrianglesOnly<kKinds>) return intersect_triangles(ray, leaf, i, t_best);
  if (HWY_LIKELY(kind == ShapeKind::sphere)) return intersect_spheres(ray, leaf, i, t_best);
  if (HWY_LIKELY(kind == ShapeKind::triangle)) return intersect_triangles(ray, leaf, i, t_best);
  if (kind == ShapeKind::cylinder) return intersect_cylinders(ray, leaf, i, t_best);
  return intersect_rectangles(ray, rectangle_axes(kind), leaf, i, t_best);
}

// The nearest of the hits, the first lane among equals (lanes stand by ascending id), if it is
// better than what was found before.
HWY_INLINE void keep_best(LaneHits hits, LeafRef leaf, const LeafRow* rows, std::size_t i,
                          Hit& best) {
  const Floats d;
  const FloatVec infinite = all(Bounds3f::kInfinity);
  const FloatVec t = hn::IfThenElse(hits.mask, hits.t, infinite);
  const FloatVec nearest = hn::MinOfLanes(d, t);
  const std::uint32_t bits = bits_of(hn::And(hits.mask, hn::Eq(t, nearest)));
  const std::size_t lane = i + static_cast<std::size_t>(__builtin_ctz(bits | 0x10000u)) % 16;
  const float t_nearest = hn::GetLane(nearest);
  const PrimId id = rows[leaf_id_row(leaf.kind())].words[lane];
  // Here precedes() of intersect_scalar.h, for what is not seen through an instance.
  if (t_nearest < best.t || (t_nearest == best.t && (id < best.prim || best.lane.in_instance()))) {
    best = {t_nearest, id, leaf.lane(lane)};
  }
}

// For leaves that hold no instances.
struct NothingInside {
  HWY_INLINE void find(const PreparedRay&, PrimId, float, Hit&) const {}
  HWY_INLINE bool occludes(const PreparedRay&, PrimId) const { return false; }
};

// Calls visit(id, entry) for the instances of a leaf whose boxes the ray enters until it returns
// false.
template <class Visit>
HWY_INLINE void for_each_instance(const PreparedRay& ray, const LeafRow* leaf, float t_best,
                                  Visit visit) {
  const std::uint32_t* ids = leaf[leaf_id_row(ShapeKind::instance)].words;
  for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
    const LaneHits boxes = enter_instance_boxes(ray, leaf, i, t_best);
    alignas(64) float entry[kLanes];
    hn::Store(boxes.t, Floats(), entry);
    for (std::uint32_t bits = bits_of(boxes.mask); bits != 0;) {
      const std::uint32_t lane = take_lowest(bits);
      if (!visit(ids[i + lane], entry[lane])) return;
    }
  }
}

// Where the numbers of a leaf stand ready to be tested: in the leaf ...
template <LeafKinds kKinds>
struct ReadyLeaf {
  HWY_INLINE const LeafRow* of(LeafRef leaf, LeafArrays leaves) {
    return leaves.rows + leaf.first_row();
  }
};

// ... or here, after it was made whole.
template <bool kOnly>
struct LeafMadeWhole {
  WholeTriangles whole;

  HWY_INLINE const LeafRow* of(LeafRef leaf, LeafArrays leaves) {
    const LeafRow* begin = leaves.rows + leaf.first_row();
    if (!kOnly && leaf.kind() != ShapeKind::triangle) return begin;
    make_whole(begin, leaves, whole);
    return whole.rows;
  }
};
template <>
struct ReadyLeaf<LeafKinds::compact_any> : LeafMadeWhole<false> {};
template <>
struct ReadyLeaf<LeafKinds::compact_triangles> : LeafMadeWhole<true> {};

// inside.find(ray, id, entry, best) looks into an instance.
template <LeafKinds kKinds, class Inside>
HWY_INLINE void intersect_leaf(const PreparedRay& ray, LeafRef leaf, LeafArrays leaves,
                               const Inside& inside, Hit& best) {
  ReadyLeaf<kKinds> ready;
  const LeafRow* begin = ready.of(leaf, leaves);
  if (kAnyKinds<kKinds> && HWY_UNLIKELY(leaf.kind() == ShapeKind::instance)) {
    for_each_instance(ray, begin, best.t, [&](PrimId id, float entry) {
      if (entry <= best.t) inside.find(ray, id, entry, best);
      return true;
    });
    return;
  }
  for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
    const LaneHits hits = intersect_lanes<kKinds>(ray, leaf.kind(), begin, i, best.t);
    if (!hn::AllFalse(Floats(), hits.mask)) keep_best(hits, leaf, begin, i, best);
  }
}

template <LeafKinds kKinds, class Inside>
HWY_INLINE bool leaf_occludes(const PreparedRay& ray, LeafRef leaf, LeafArrays leaves,
                              const Inside& inside) {
  ReadyLeaf<kKinds> ready;
  const LeafRow* begin = ready.of(leaf, leaves);
  bool occluded = false;
  if (kAnyKinds<kKinds> && HWY_UNLIKELY(leaf.kind() == ShapeKind::instance)) {
    for_each_instance(ray, begin, ray.t_max, [&](PrimId id, float) {
      occluded = inside.occludes(ray, id);
      return !occluded;
    });
    return occluded;
  }
  for (std::size_t i = 0; i < kLeafWidth && !occluded; i += kLanes) {
    const LaneHits hits = intersect_lanes<kKinds>(ray, leaf.kind(), begin, i, ray.t_max);
    occluded = !hn::AllFalse(Floats(), hits.mask);
  }
  return occluded;
}

// See keep_seen_through() of intersect_scalar.h.
HWY_INLINE void keep_seen_through(std::size_t instance, float entry, Hit inside, Hit& best) {
  if (inside.prim == kNoPrim) return;
  inside.t = inside.t > entry ? inside.t : entry;
  inside.lane = inside.lane.through(instance);
  const std::uint32_t before = best.lane.seen_through(), now = inside.lane.seen_through();
  const bool precedes =
      best.prim == kNoPrim || now < before || (now == before && inside.prim < best.prim);
  if (inside.t < best.t || (inside.t == best.t && precedes)) best = inside;
}

// What a search starts from and, when nothing was found, must not return.
HWY_INLINE Hit nothing_before(float t_max) { return {t_max, kNoPrim, {}}; }
HWY_INLINE Hit finished(const Hit& best) { return best.prim == kNoPrim ? Hit{} : best; }
// The same for kLanes of them, with their lanes in halves.
HWY_INLINE void store_hits(FloatVec t, WordVec prim, WordVec lane_low, WordVec lane_high,
                           Hit* hits) {
  const Words d;
  const WordMask found = hn::Ne(prim, all_words(kNoPrim));
  const FloatVec finite = hn::IfThenElse(float_mask(found), t, all(Bounds3f::kInfinity));
  hn::StoreInterleaved4(bits_of_floats(finite), prim, hn::IfThenElseZero(found, lane_low),
                        hn::IfThenElseZero(found, lane_high), d,
                        reinterpret_cast<std::uint32_t*>(hits));
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
