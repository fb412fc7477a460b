#include "accel/range_splitter.h"

#include <algorithm>

#include "accel/sah_split.h"
#include "accel/spatial_split.h"
#include "scene/prims.h"

namespace dapple {
namespace {

// Parts of triangles that a range may have beyond its primitives, as a share of these.
constexpr double kRoom = 1.0;
// Space is split where both sides of the best ordinary split share that much of the surface, and
// even if it seems to cost a little more: smaller boxes make later splits better.
constexpr float kOverlap = 0.1f, kTolerance = 1.15f;
// What makes two leaves as it is gains nothing.
constexpr std::size_t kLeastSpatial = 2 * kLeafWidth + 1;

}  // namespace

RangeSplitter::RangeSplitter(const SceneView& scene, const PrototypeBoxes& prototypes,
                             HugeArray<BuildPrim> prims, BvhQuality quality, LeafForm form)
    : scene_(scene),
      prototypes_(prototypes),
      first_ids_(first_prim_ids(scene)),
      quality_(quality),
      form_(form),
      prims_(std::move(prims)),
      scratch_(prims_.size() > kParallelRange ? prims_.size() : 0) {}

bool RangeSplitter::can_split_any(const PrimRange& range, const TriangleClipper& clipper) const {
  const auto prims = prims_.span().subspan(range.begin, range.size());
  return std::any_of(prims.begin(), prims.end(),
                     [&](const BuildPrim& prim) { return clipper.can_split(prim); });
}

RangeSplitter RangeSplitter::with_room(const PrimRange& range,
                                       const TriangleClipper& clipper) const {
  const auto room = static_cast<std::size_t>(kRoom * static_cast<double>(range.size()));
  HugeArray<BuildPrim> prims(range.size() + room);
  std::copy(prims_.data() + range.begin, prims_.data() + range.end, prims.data());
  RangeSplitter result(scene_, prototypes_, std::move(prims), quality_, form_);
  result.room_ = room;
  result.clipper_ = &clipper;
  return result;
}

PrimRange RangeSplitter::whole() const {
  PrimRange range = measure_range(prims_.span(), 0, prims_.size() - room_);
  range.room = room_;
  return range;
}

ShapeKind RangeSplitter::kind_of(PrimId id) const {
  std::size_t kind = kShapeKindCount - 1;
  while (id < first_ids_[kind]) --kind;
  return static_cast<ShapeKind>(kind);
}

bool RangeSplitter::is_leaf(const PrimRange& range) const {
  if (range.size() > kLeafWidth) return false;
  const ShapeKind kind = leaf_kind(range);
  for (std::size_t i = range.begin + 1; i < range.end; ++i) {
    if (kind_of(prims_[i].id) != kind) return false;
  }
  return true;
}

RangePair RangeSplitter::cut(const PrimRange& range, std::size_t middle) const {
  return {measure_range(prims_.span(), range.begin, middle),
          measure_range(prims_.span(), middle, range.end)};
}

// In half by id, or where the kind changes when that is within one leaf's worth.
RangePair RangeSplitter::split_by_id(const PrimRange& range) {
  BuildPrim* const begin = prims_.data() + range.begin;
  BuildPrim* const end = prims_.data() + range.end;
  const auto by_id = [](const BuildPrim& a, const BuildPrim& b) { return a.id < b.id; };
  if (range.size() > kLeafWidth) {
    BuildPrim* const middle = begin + range.size() / 2;
    std::nth_element(begin, middle, end, by_id);
    return cut(range, static_cast<std::size_t>(middle - prims_.data()));
  }
  std::sort(begin, end, by_id);
  const ShapeKind kind = kind_of(begin->id);
  const auto change =
      std::find_if(begin, end, [&](const BuildPrim& prim) { return kind_of(prim.id) != kind; });
  return cut(range, static_cast<std::size_t>(change - prims_.data()));
}

std::optional<SpatialSplit> RangeSplitter::worthwhile_spatial_split(const PrimRange& range,
                                                                    const SahSplit& other) const {
  if (range.room == 0 || range.size() < kLeastSpatial) return std::nullopt;
  if (!(other.overlap > kOverlap * range.box.half_area())) return std::nullopt;
  const auto spatial = find_spatial_split(*clipper_, prims_.span(), range);
  return spatial && spatial->cost < kTolerance * other.cost ? spatial : std::nullopt;
}

RangePair RangeSplitter::split(const PrimRange& range, SplitBy by) {
  if (range.size() <= kLeafWidth || by == SplitBy::number) return split_by_id(range);
  const auto best = find_split(prims_.span(), range, quality_);
  if (!best) return split_by_id(range);
  if (const auto spatial = worthwhile_spatial_split(range, *best)) {
    return partition_spatially(*clipper_, prims_.span(), range, *spatial);
  }
  return share_room(prims_.span(), partition_range(prims_.span(), scratch_.span(), range, *best),
                    range.room);
}

void RangeSplitter::write_leaf(const PrimRange& range, LeafRow* leaf) const {
  std::array<PrimId, kLeafWidth> ids;
  for (std::size_t i = 0; i < range.size(); ++i) ids[i] = prims_[range.begin + i].id;
  std::sort(ids.begin(), ids.begin() + range.size());
  const auto count =
      static_cast<std::size_t>(std::unique(ids.begin(), ids.begin() + range.size()) - ids.begin());
  const ShapeKind kind = leaf_kind(range);
  const std::size_t first_id = first_ids_[static_cast<std::size_t>(kind)];
  clear_leaf(kind, leaf, form_);
  for (std::size_t i = 0; i < count; ++i) {
    write_lane(scene_, prototypes_, kind, ids[i] - first_id, ids[i], leaf, i, form_);
  }
}

void RangeSplitter::forget(const PrimRange& range) noexcept {
  if (!gives_back()) return;
  prims_.forget(range.begin, range.end);
  if (scratch_.size() != 0) scratch_.forget(range.begin, range.end);
}

}  // namespace dapple
