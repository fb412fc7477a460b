#include "accel/range_splitter.h"

#include <algorithm>

#include "accel/sah_split.h"
#include "scene/prims.h"

namespace dapple {

RangeSplitter::RangeSplitter(const SceneView& scene, const PrototypeBoxes& prototypes,
                             HugeArray<BuildPrim> prims, BvhQuality quality)
    : scene_(scene),
      prototypes_(prototypes),
      first_ids_(first_prim_ids(scene)),
      quality_(quality),
      prims_(std::move(prims)),
      scratch_(prims_.size() > kParallelRange ? prims_.size() : 0) {}

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

RangePair RangeSplitter::split(const PrimRange& range, SplitBy by) {
  if (range.size() <= kLeafWidth || by == SplitBy::number) return split_by_id(range);
  const auto best = find_split(prims_.span(), range, quality_);
  if (!best) return split_by_id(range);
  return partition_range(prims_.span(), scratch_.span(), range, *best);
}

void RangeSplitter::write_leaf(const PrimRange& range, LeafRow* leaf, LeafForm form) const {
  std::array<PrimId, kLeafWidth> ids;
  for (std::size_t i = 0; i < range.size(); ++i) ids[i] = prims_[range.begin + i].id;
  std::sort(ids.begin(), ids.begin() + range.size());
  const ShapeKind kind = leaf_kind(range);
  const std::size_t first_id = first_ids_[static_cast<std::size_t>(kind)];
  clear_leaf(kind, leaf, form);
  for (std::size_t i = 0; i < range.size(); ++i) {
    write_lane(scene_, prototypes_, kind, ids[i] - first_id, ids[i], leaf, i, form);
  }
}

void RangeSplitter::forget(const PrimRange& range) noexcept {
  if (!gives_back()) return;
  prims_.forget(range.begin, range.end);
  if (scratch_.size() != 0) scratch_.forget(range.begin, range.end);
}

}  // namespace dapple
