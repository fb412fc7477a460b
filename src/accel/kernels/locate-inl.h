// Accel::locate for one hit a lane, operation for operation.
#include "accel/accel.h"
#include "math/simd-inl.h"

#if defined(DAPPLE_KERNELS_LOCATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_LOCATE_INL_H
#undef DAPPLE_KERNELS_LOCATE_INL_H
#else
#define DAPPLE_KERNELS_LOCATE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Rays and where they hit; a lane without a hit has a word of some leaf all the same.
struct HitVec {
  FloatVec3 origin, direction;
  FloatVec t;
  WordVec lane_low, lane_high;  // halves of the LeafRef
};

struct SurfacePointVec {
  FloatVec3 position, outward;
  FloatVec error;
};

// The bits of a LeafRef without its kind count words from the first row.
struct LeafWords {
  const std::uint32_t* words;
  WordVec low, high;
  bool near;  // all indices are small enough for a gather
};

HWY_INLINE LeafWords leaf_words(const LeafRow* rows, const HitVec& hit) {
  const Words d;
  const WordVec high = hn::And(hit.lane_high, all_words(0x0fffffffu));
  // The farthest number of a leaf stands four rows on.
  const WordVec last = hn::Add(hit.lane_low, all_words(4 * kLeafWidth));
  const WordVec outside =
      hn::Or(hn::Or(high, hn::ShiftRight<31>(hit.lane_low)), hn::ShiftRight<31>(last));
  return {rows->words, hit.lane_low, high, hn::AllTrue(d, hn::Eq(outside, hn::Zero(d)))};
}

HWY_INLINE FloatVec gather_far(const LeafWords& leaf, std::size_t row) {
  HWY_ALIGN std::uint32_t low[kLanes], high[kLanes], result[kLanes];
  hn::Store(leaf.low, Words(), low);
  hn::Store(leaf.high, Words(), high);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const std::uint64_t index = std::uint64_t{high[i]} << 32 | low[i];
    result[i] = leaf.words[index + row * kLeafWidth];
  }
  return floats_of_bits(hn::Load(Words(), result));
}

HWY_INLINE FloatVec leaf_floats(const LeafWords& leaf, std::size_t row) {
  if (HWY_UNLIKELY(!leaf.near)) return gather_far(leaf, row);
  return floats_of_bits(gather(leaf.words + row * kLeafWidth, leaf.low));
}

HWY_INLINE SurfacePointVec locate_on_spheres(const HitVec& hit, const LeafWords& leaf) {
  const FloatVec3 centre = {leaf_floats(leaf, 0), leaf_floats(leaf, 1), leaf_floats(leaf, 2)};
  const FloatVec radius = leaf_floats(leaf, 3);
  const FloatVec3 radial = (hit.origin - centre) + hit.t * hit.direction;
  const FloatVec squared = dot(radial, radial);
  const FloatMask has_digits = hn::Ge(squared, all(kSmallestNormal));
  FloatVec3 normal = radial / hn::Sqrt(squared);
  if (HWY_UNLIKELY(!hn::AllTrue(Floats(), has_digits))) {
    normal = select(has_digits, normal, -normalize(hit.direction));
  }
  const FloatVec size = hn::Abs(radius);
  return {centre + size * normal, select(hn::Lt(radius, hn::Zero(Floats())), -normal, normal),
          hn::Mul(all(kPositionError), hn::Add(max_abs_component(centre), size))};
}

HWY_INLINE SurfacePointVec locate_on_rectangles(const HitVec& hit, const LeafWords& leaf,
                                                WordVec kind) {
  const auto of_kind = [](ShapeKind k) { return static_cast<std::uint32_t>(k); };
  const FloatMask along_x = float_mask(hn::Eq(kind, all_words(of_kind(ShapeKind::yz_rectangle))));
  const FloatMask along_y = float_mask(hn::Eq(kind, all_words(of_kind(ShapeKind::xz_rectangle))));
  const FloatMask along_z = float_mask(hn::Eq(kind, all_words(of_kind(ShapeKind::xy_rectangle))));
  const FloatVec k = leaf_floats(leaf, 4);
  const FloatVec3 on_ray = hit.origin + hit.t * hit.direction;
  const FloatVec3 position = {hn::IfThenElse(along_x, k, on_ray.x),
                              hn::IfThenElse(along_y, k, on_ray.y),
                              hn::IfThenElse(along_z, k, on_ray.z)};
  const FloatVec one = all(1.0f);
  return {position,
          {hn::IfThenElseZero(along_x, one), hn::IfThenElseZero(along_y, one),
           hn::IfThenElseZero(along_z, one)},
          hn::Mul(all(kPositionError), max_abs_component(position))};
}

HWY_INLINE SurfacePointVec locate(const LeafRow* rows, const HitVec& hit) {
  const LeafWords leaf = leaf_words(rows, hit);
  const WordVec kind = hn::ShiftRight<28>(hit.lane_high);
  const FloatMask sphere = float_mask(hn::Eq(kind, hn::Zero(Words())));
  if (HWY_LIKELY(hn::AllTrue(Floats(), sphere))) return locate_on_spheres(hit, leaf);
  const SurfacePointVec flat = locate_on_rectangles(hit, leaf, kind);
  if (!any(sphere)) return flat;
  const SurfacePointVec round = locate_on_spheres(hit, leaf);
  return {select(sphere, round.position, flat.position),
          select(sphere, round.outward, flat.outward),
          hn::IfThenElse(sphere, round.error, flat.error)};
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
