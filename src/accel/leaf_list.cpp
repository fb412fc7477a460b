#include "accel/leaf_list.h"

#include <algorithm>

#include "scene/prims.h"

namespace dapple {

LeafList::LeafList(const SceneView& scene) : first_ids_(first_prim_ids(scene)) {
  std::size_t row_count = 0;
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    first_leaves_[k] = leaves_.size();
    for (std::size_t i = 0; i < scene.object_count(kind); i += kLeafWidth) {
      leaves_.emplace_back(kind, row_count);
      row_count += leaf_rows(kind);
    }
  }
  rows_ = HugeArray<LeafRow>(row_count);
  for (const LeafRef leaf : leaves_) clear_leaf(leaf.kind(), rows_.data() + leaf.first_row());
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    for (std::size_t i = 0; i < scene.object_count(kind); ++i) {
      const auto id = static_cast<PrimId>(first_ids_[k] + i);
      const LeafRef lane = lane_of(id);
      write_lane(scene, kind, i, id, rows_.data() + lane.first_row(), lane.lane_index());
    }
  }
}

LeafRef LeafList::lane_of(PrimId id) const {
  std::size_t kind = kShapeKindCount - 1;
  while (id < first_ids_[kind]) --kind;
  const std::size_t index = id - first_ids_[kind];
  return leaves_[first_leaves_[kind] + index / kLeafWidth].lane(index % kLeafWidth);
}

}  // namespace dapple
