// Accel::locate for one hit a lane, operation for operation.
#include "accel/accel.h"
#include "accel/kernels/positions-inl.h"
#include "accel/locate.h"
#include "accel/prepared_ray.h"
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

// The lower half of a LeafRef counts words from the first row.
struct LeafWords {
  const std::uint32_t* words;
  WordVec index;
  bool near;               // all indices are small enough for a gather
  const Vec3f* positions;  // if the leaves are compact
  std::uint32_t last_vertex;
};

HWY_INLINE LeafWords leaf_words(const LeafArrays& leaves, const HitVec& hit) {
  const Words d;
  // The farthest number of a leaf stands less than kMaxLeafRows on.
  const WordVec last = hn::Add(hit.lane_low, all_words(kMaxLeafRows * kLeafWidth));
  const WordVec outside = hn::ShiftRight<31>(hn::Or(hit.lane_low, last));
  return {leaves.rows->words, hit.lane_low, hn::AllTrue(d, hn::Eq(outside, hn::Zero(d))),
          leaves.positions, leaves.last_vertex};
}

HWY_INLINE WordVec gather_far(const LeafWords& leaf, std::size_t row) {
  HWY_ALIGN std::uint32_t index[kLanes], result[kLanes];
  hn::Store(leaf.index, Words(), index);
  for (std::size_t i = 0; i < kLanes; ++i) {
    result[i] = leaf.words[std::size_t{index[i]} + row * kLeafWidth];
  }
  return hn::Load(Words(), result);
}

HWY_INLINE WordVec leaf_words(const LeafWords& leaf, std::size_t row) {
  if (HWY_UNLIKELY(!leaf.near)) return gather_far(leaf, row);
  return gather(leaf.words + row * kLeafWidth, leaf.index);
}
HWY_INLINE FloatVec leaf_floats(const LeafWords& leaf, std::size_t row) {
  return floats_of_bits(leaf_words(leaf, row));
}

// A vertex of triangles, the i-th of three. What a lane without a triangle takes for its index must
// be one all the same.
HWY_INLINE FloatVec3 corner_of_triangles(const LeafWords& leaf, std::size_t i) {
  if (leaf.positions == nullptr) {
    return {leaf_floats(leaf, 3 * i), leaf_floats(leaf, 3 * i + 1), leaf_floats(leaf, 3 * i + 2)};
  }
  HWY_ALIGN std::uint32_t vertices[kLanes];
  hn::Store(hn::Min(leaf_words(leaf, i), all_words(leaf.last_vertex)), Words(), vertices);
  return load_positions<AfterLast::nothing>(leaf.positions, vertices);
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

// Components of a vector in the frame of a ray whose largest component is along an axis.
struct FrameAxes {
  FloatMask along_x, along_y;  // or else along z

  HWY_INLINE FloatVec3 operator()(FloatVec3 v) const {
    return {hn::IfThenElse(along_x, v.y, hn::IfThenElse(along_y, v.z, v.x)),
            hn::IfThenElse(along_x, v.z, hn::IfThenElse(along_y, v.x, v.y)),
            hn::IfThenElse(along_x, v.x, hn::IfThenElse(along_y, v.y, v.z))};
  }
};

HWY_INLINE FrameAxes frame_axes(FloatVec3 direction) {
  const FloatVec x = hn::Abs(direction.x), y = hn::Abs(direction.y), z = hn::Abs(direction.z);
  const FloatMask x_over_y = hn::Ge(x, y);
  return {hn::And(x_over_y, hn::Ge(x, z)), hn::AndNot(x_over_y, hn::Ge(y, z))};
}

HWY_INLINE SurfacePointVec locate_on_triangles(const HitVec& hit, const LeafWords& leaf) {
  const FloatVec3 corners[3] = {corner_of_triangles(leaf, 0), corner_of_triangles(leaf, 1),
                                corner_of_triangles(leaf, 2)};
  const FrameAxes axes = frame_axes(hit.direction);
  const FloatVec3 direction = axes(hit.direction), origin = axes(hit.origin);
  const FloatVec smallest = all(kSmallestDirection);
  const FloatVec inverse =
      hn::Div(all(1.0f), hn::IfThenElse(hn::Lt(hn::Abs(direction.z), smallest),
                                        hn::CopySign(smallest, direction.z), direction.z));
  const FloatVec shear_x = hn::Mul(direction.x, inverse);
  const FloatVec shear_y = hn::Mul(direction.y, inverse);
  FloatVec x[3], y[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const FloatVec3 seen = axes(corners[i]) - origin;
    x[i] = hn::Sub(seen.x, hn::Mul(shear_x, seen.z));
    y[i] = hn::Sub(seen.y, hn::Mul(shear_y, seen.z));
  }
  const FloatVec of_a = hn::Sub(hn::Mul(x[2], y[1]), hn::Mul(y[2], x[1]));
  const FloatVec of_b = hn::Sub(hn::Mul(x[0], y[2]), hn::Mul(y[0], x[2]));
  const FloatVec of_c = hn::Sub(hn::Mul(x[1], y[0]), hn::Mul(y[1], x[0]));
  const FloatVec scale = hn::Div(all(1.0f), hn::Add(hn::Add(of_a, of_b), of_c));
  const FloatVec u = hn::Mul(of_b, scale), v = hn::Mul(of_c, scale);
  const FloatVec3 to_b = corners[1] - corners[0], to_c = corners[2] - corners[0];
  const FloatVec size =
      hn::Div(all(1.0f), larger(max_abs_component(to_b), max_abs_component(to_c)));
  const FloatVec3 b = size * to_b, c = size * to_c;
  const FloatVec3 normal = {hn::Sub(hn::Mul(b.y, c.z), hn::Mul(b.z, c.y)),
                            hn::Sub(hn::Mul(b.z, c.x), hn::Mul(b.x, c.z)),
                            hn::Sub(hn::Mul(b.x, c.y), hn::Mul(b.y, c.x))};
  const FloatVec squared = dot(normal, normal);
  const FloatMask has_digits = hn::Ge(squared, all(kSmallestNormal));
  const FloatVec largest =
      larger(larger(max_abs_component(corners[0]), max_abs_component(corners[1])),
             max_abs_component(corners[2]));
  return {(corners[0] + u * to_b) + v * to_c,
          select(has_digits, normal / hn::Sqrt(squared), -normalize(hit.direction)),
          hn::Mul(all(kTrianglePositionError), largest)};
}

HWY_INLINE SurfacePointVec select(FloatMask mask, const SurfacePointVec& yes,
                                  const SurfacePointVec& no) {
  return {select(mask, yes.position, no.position), select(mask, yes.outward, no.outward),
          hn::IfThenElse(mask, yes.error, no.error)};
}

// Lanes of `there` one by one, by the scalar definition.
HWY_INLINE SurfacePointVec locate_one_by_one(const LeafArrays& leaves,
                                             const PlacedInstance* instances, const HitVec& hit,
                                             FloatMask there) {
  const Floats d;
  const Words w;
  HWY_ALIGN float numbers[7][kLanes];
  HWY_ALIGN std::uint32_t low[kLanes], high[kLanes];
  const FloatVec inputs[7] = {hit.origin.x,    hit.origin.y,    hit.origin.z, hit.direction.x,
                              hit.direction.y, hit.direction.z, hit.t};
  for (std::size_t i = 0; i < 7; ++i) hn::Store(inputs[i], d, numbers[i]);
  hn::Store(hn::IfThenElseZero(word_mask(there), hit.lane_low), w, low);
  hn::Store(hn::IfThenElseZero(word_mask(there), hit.lane_high), w, high);
  for (std::size_t i = 0; i < kLanes; ++i) {
    if ((low[i] | high[i]) == 0) continue;
    locate_lane(leaves, instances, numbers[0] + i, kLanes, std::uint64_t{high[i]} << 32 | low[i]);
  }
  const auto result = [&](std::size_t i) { return hn::Load(d, numbers[i]); };
  return {{result(0), result(1), result(2)}, {result(3), result(4), result(5)}, result(6)};
}

HWY_INLINE SurfacePointVec locate(const LeafArrays& leaves, const PlacedInstance* instances,
                                  const HitVec& hit) {
  const Words d;
  const LeafWords leaf = leaf_words(leaves, hit);
  const WordVec kind = hn::ShiftRight<28>(hit.lane_high);
  const FloatMask sphere = float_mask(hn::Eq(kind, hn::Zero(d)));
  if (HWY_LIKELY(hn::AllTrue(Floats(), sphere))) return locate_on_spheres(hit, leaf);
  const auto triangle_kind = static_cast<std::uint32_t>(ShapeKind::triangle);
  const FloatMask triangle = float_mask(hn::Eq(hit.lane_high, all_words(triangle_kind << 28)));
  SurfacePointVec at = locate_on_rectangles(hit, leaf, kind);
  if (any(triangle)) {
    // A triangle has more rows than others, which need not exist for a leaf of those.
    const LeafWords of_triangles = {leaf.words, hn::IfThenElseZero(word_mask(triangle), leaf.index),
                                    leaf.near, leaf.positions, leaf.last_vertex};
    at = select(triangle, locate_on_triangles(hit, of_triangles), at);
  }
  const FloatMask seldom = float_mask(hn::Gt(hit.lane_high, all_words(triangle_kind << 28)));
  if (any(seldom)) at = select(seldom, locate_one_by_one(leaves, instances, hit, seldom), at);
  if (any(sphere)) at = select(sphere, locate_on_spheres(hit, leaf), at);
  return at;
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
