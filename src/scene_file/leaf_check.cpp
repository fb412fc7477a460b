// Compiled once for each instruction set, by Highway's foreach_target; so nothing of std:: here.
#include "scene_file/leaf_check.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene_file/leaf_check.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "scene/scene_view.h"
#include "scene/validate.h"

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, kLeafWidth>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using WordVec = hn::Vec<Words>;
using Mask = hn::Mask<Floats>;

HWY_INLINE FloatVec all(float x) { return hn::Set(Floats(), x); }
HWY_INLINE WordVec all(std::uint32_t x) { return hn::Set(Words(), x); }
HWY_INLINE WordVec load_words(const std::uint32_t* from) { return hn::LoadU(Words(), from); }
HWY_INLINE Mask as_float_mask(hn::Mask<Words> mask) { return hn::RebindMask(Floats(), mask); }

// Where a lane is wrong, for each reason; judged for kLanes lanes from `first` on.
struct Faults {
  Mask order, unused, id, coordinate, box;
};

struct LeafLanes {
  const LeafRow* rows;
  std::size_t first;

  HWY_INLINE WordVec words(std::size_t row) const { return load_words(rows[row].words + first); }
  HWY_INLINE FloatVec floats(std::size_t row) const { return hn::BitCast(Floats(), words(row)); }
};

// True for NaN.
HWY_INLINE Mask out_of_range(FloatVec x) {
  return hn::Not(hn::Le(hn::Abs(x), all(static_cast<float>(kMaxCoordinate))));
}
HWY_INLINE Mask outside(FloatVec lo, FloatVec hi, const Bounds3f& box, int axis) {
  return hn::Not(hn::And(hn::Ge(lo, all(box.lo[axis])), hn::Le(hi, all(box.hi[axis]))));
}

HWY_INLINE void check_spheres(const LeafLanes& lanes, const Bounds3f& box, Faults& faults) {
  const FloatVec radius = lanes.floats(3);
  const FloatVec size = hn::Abs(radius);
  faults.coordinate = out_of_range(radius);
  faults.box = hn::Not(hn::Eq(radius, radius));
  WordVec bits = lanes.words(3);
  for (int axis = 0; axis < 3; ++axis) {
    const auto row = static_cast<std::size_t>(axis);
    const FloatVec centre = lanes.floats(row);
    bits = hn::Or(bits, lanes.words(row));
    faults.coordinate = hn::Or(faults.coordinate, out_of_range(centre));
    const Mask out = outside(hn::Sub(centre, size), hn::Add(centre, size), box, axis);
    faults.box = hn::Or(faults.box, out);
  }
  faults.unused = as_float_mask(hn::Ne(bits, all(0u)));
}

HWY_INLINE void check_rectangles(ShapeKind kind, const LeafLanes& lanes, const Bounds3f& box,
                                 Faults& faults) {
  constexpr std::uint32_t kInfinityBits = 0x7f800000u;
  const RectangleAxes axes = rectangle_axes(kind);
  const FloatVec k = lanes.floats(4);
  faults.coordinate = out_of_range(k);
  faults.box = outside(k, k, box, axes.k);
  const int axis_of[2] = {axes.u, axes.v};
  for (std::size_t i = 0; i < 2; ++i) {
    const FloatVec lo = lanes.floats(2 * i);
    const FloatVec hi = lanes.floats(2 * i + 1);
    faults.coordinate = hn::Or(faults.coordinate, hn::Or(out_of_range(lo), out_of_range(hi)));
    faults.box = hn::Or(faults.box, outside(lo, hi, box, axis_of[i]));
  }
  const WordVec u0 = hn::Xor(lanes.words(0), all(kInfinityBits));
  const WordVec u1 = hn::Xor(lanes.words(1), all(kInfinityBits | 0x80000000u));
  const WordVec others = hn::Or(lanes.words(2), hn::Or(lanes.words(3), lanes.words(4)));
  faults.unused = as_float_mask(hn::Ne(hn::Or(others, hn::Or(u0, u1)), all(0u)));
}

// Both ends, with the radius all around, as the cylinder's own box has it.
HWY_INLINE void check_cylinders(const LeafLanes& lanes, const Bounds3f& box, Faults& faults) {
  const FloatVec radius = lanes.floats(6);
  const FloatVec size = hn::Abs(radius);
  faults.coordinate = out_of_range(radius);
  faults.box = hn::Not(hn::Eq(radius, radius));
  WordVec bits = lanes.words(6);
  for (std::size_t row = 0; row < 6; ++row) {
    const FloatVec at = lanes.floats(row);
    bits = hn::Or(bits, lanes.words(row));
    faults.coordinate = hn::Or(faults.coordinate, out_of_range(at));
    const Mask out = outside(hn::Sub(at, size), hn::Add(at, size), box, static_cast<int>(row % 3));
    faults.box = hn::Or(faults.box, out);
  }
  faults.unused = as_float_mask(hn::Ne(bits, all(0u)));
}

HWY_INLINE void check_triangles(const LeafLanes& lanes, const Bounds3f& box, Faults& faults) {
  faults.coordinate = faults.box = hn::FirstN(Floats(), 0);
  WordVec bits = all(0u);
  for (std::size_t row = 0; row < 9; ++row) {
    const FloatVec at = lanes.floats(row);
    bits = hn::Or(bits, lanes.words(row));
    faults.coordinate = hn::Or(faults.coordinate, out_of_range(at));
    faults.box = hn::Or(faults.box, outside(at, at, box, static_cast<int>(row % 3)));
  }
  faults.unused = as_float_mask(hn::Ne(bits, all(0u)));
}

// The boxes of instances in the world; lanes that are not in use have the empty box.
HWY_INLINE void check_instances(const LeafLanes& lanes, const Bounds3f& box, Faults& faults) {
  constexpr std::uint32_t kInfinityBits = 0x7f800000u;
  faults.coordinate = faults.box = hn::FirstN(Floats(), 0);
  WordVec bits = all(0u);
  for (std::size_t row = 0; row < 3; ++row) {
    const FloatVec lo = lanes.floats(row), hi = lanes.floats(row + 3);
    bits = hn::Or(bits, hn::Xor(lanes.words(row), all(kInfinityBits)));
    bits = hn::Or(bits, hn::Xor(lanes.words(row + 3), all(kInfinityBits | 0x80000000u)));
    faults.coordinate = hn::Or(faults.coordinate, hn::Or(out_of_range(lo), out_of_range(hi)));
    faults.box = hn::Or(faults.box, outside(lo, hi, box, static_cast<int>(row)));
  }
  faults.unused = as_float_mask(hn::Ne(bits, all(0u)));
}

HWY_INLINE void check_shapes(ShapeKind kind, const LeafLanes& lanes, const Bounds3f& box,
                             Faults& faults) {
  if (kind == ShapeKind::sphere) return check_spheres(lanes, box, faults);
  if (kind == ShapeKind::triangle) return check_triangles(lanes, box, faults);
  if (kind == ShapeKind::cylinder) return check_cylinders(lanes, box, faults);
  if (kind == ShapeKind::instance) return check_instances(lanes, box, faults);
  check_rectangles(kind, lanes, box, faults);
}

// Each id must be above the one before it, except that kNoPrim follows kNoPrim: so lanes in use
// come first.
HWY_INLINE void check_ids(const LeafLanes& lanes, std::size_t row, IdRange ids, Faults& faults) {
  const WordVec id = lanes.words(row);
  // Lane 0 reads the end of the row before and is not judged.
  const auto* words = reinterpret_cast<const std::uint32_t*>(lanes.rows);
  const WordVec before = load_words(words + row * kLeafWidth + lanes.first - 1);
  const Mask no_one_before =
      hn::FirstN(Floats(), static_cast<std::size_t>(lanes.first == 0 ? 1 : 0));
  const auto ascending =
      hn::Or(hn::Lt(before, id), hn::And(hn::Eq(before, id), hn::Eq(id, all(kNoPrim))));
  faults.order = hn::Not(hn::Or(no_one_before, as_float_mask(ascending)));
  // An id below the first wraps round to a large number.
  const WordVec index = hn::Sub(id, all(ids.first));
  faults.id = hn::Not(as_float_mask(hn::Lt(index, all(ids.count))));
}

HWY_INLINE bool any(Mask mask) { return !hn::AllFalse(Floats(), mask); }

LeafFault fault_of(const Faults& faults, Mask used) {
  if (any(faults.order)) return LeafFault::order;
  if (any(hn::And(hn::Not(used), faults.unused))) return LeafFault::unused;
  if (any(hn::And(used, faults.id))) return LeafFault::id;
  if (any(hn::And(used, faults.coordinate))) return LeafFault::coordinate;
  return any(hn::And(used, faults.box)) ? LeafFault::box : LeafFault::none;
}

LeafVerdict check_leaf(ShapeKind kind, const LeafRow* leaf, const Bounds3f& box, IdRange ids) {
  constexpr std::size_t kLanes = hn::MaxLanes(Floats());
  LeafVerdict verdict;
  for (std::size_t first = 0; first < kLeafWidth; first += kLanes) {
    const LeafLanes lanes{leaf, first};
    Faults faults;
    check_shapes(kind, lanes, box, faults);
    check_ids(lanes, leaf_id_row(kind), ids, faults);
    const Mask used = as_float_mask(hn::Ne(lanes.words(leaf_id_row(kind)), all(kNoPrim)));
    const Mask bad_if_used = hn::Or(faults.id, hn::Or(faults.coordinate, faults.box));
    const Mask bad = hn::Or(
        faults.order, hn::Or(hn::And(used, bad_if_used), hn::And(hn::Not(used), faults.unused)));
    if (any(bad)) return {fault_of(faults, used), 0};
    verdict.count += hn::CountTrue(Floats(), used);
  }
  if (verdict.count == 0) verdict.fault = LeafFault::empty;
  return verdict;
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dapple {
namespace {

struct Level {
  std::int64_t target;
  LeafCheck check;
};

// Best first. The last one runs everywhere.
constexpr Level kLevels[] = {
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3, N_AVX3::check_leaf},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2, N_AVX2::check_leaf},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4, N_SSE4::check_leaf},
#endif
#if HWY_TARGETS & HWY_SSSE3
    {HWY_SSSE3, N_SSSE3::check_leaf},
#endif
    {HWY_STATIC_TARGET, HWY_STATIC_DISPATCH(check_leaf)},
};

// No container: its functions would be weak symbols of an object that holds AVX-512 code.
struct List {
  LeafCheck checks[sizeof(kLevels) / sizeof(kLevels[0])] = {};
  std::size_t count = 0;

  List() {
    const std::int64_t supported = hwy::SupportedTargets() | HWY_STATIC_TARGET;
    for (const Level& level : kLevels) {
      if ((supported & level.target) != 0) checks[count++] = level.check;
    }
  }
};

}  // namespace

std::span<const LeafCheck> leaf_checks() {
  static const List list;
  return {list.checks, list.count};
}

}  // namespace dapple
#endif  // HWY_ONCE
