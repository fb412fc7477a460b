#include "accel/leaf_list.h"

#include <algorithm>

#include "scene/prims.h"

namespace dapple {

LeafList::LeafList(const SceneView& scene) {
  const auto first_ids = first_prim_ids(scene);
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    add_group(kind, first_ids[k], scene.object_count(kind));
  }
  world_leaf_count_ = leaves_.size();
  const std::size_t first_triangle = first_ids[static_cast<std::size_t>(ShapeKind::triangle)];
  for (const Prototype& prototype : scene.prototypes) {
    add_group(ShapeKind::triangle, first_triangle + prototype.first_triangle,
              prototype.triangle_count);
    prototype_ends_.push_back(leaves_.size());
  }
  std::sort(groups_.begin(), groups_.end(),
            [](const Group& a, const Group& b) { return a.first_id < b.first_id; });
  rows_ = HugeArray<LeafRow>(row_count_);
  for (const LeafRef leaf : leaves_) clear_leaf(leaf.kind(), rows_.data() + leaf.first_row());
  const PrototypeBoxes boxes = prototype_boxes(scene);
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    for (std::size_t i = 0; i < scene.count(kind); ++i) {
      const auto id = static_cast<PrimId>(first_ids[k] + i);
      const LeafRef lane = lane_of(id);
      write_lane(scene, boxes, kind, i, id, rows_.data() + lane.first_row(), lane.lane_index());
    }
  }
}

void LeafList::add_group(ShapeKind kind, std::size_t first_id, std::size_t count) {
  if (count > 0) groups_.push_back({first_id, leaves_.size()});
  for (std::size_t i = 0; i < count; i += kLeafWidth) {
    leaves_.emplace_back(kind, row_count_);
    row_count_ += leaf_rows(kind);
  }
}

std::span<const LeafRef> LeafList::leaves_of_prototype(std::size_t prototype) const {
  const std::size_t begin = prototype == 0 ? world_leaf_count_ : prototype_ends_[prototype - 1];
  return std::span(leaves_).subspan(begin, prototype_ends_[prototype] - begin);
}

LeafRef LeafList::lane_of(PrimId id) const {
  const auto after =
      std::upper_bound(groups_.begin(), groups_.end(), id,
                       [](PrimId wanted, const Group& group) { return wanted < group.first_id; });
  const Group& group = *(after - 1);
  const std::size_t index = id - group.first_id;
  return leaves_[group.first_leaf + index / kLeafWidth].lane(index % kLeafWidth);
}

}  // namespace dapple
