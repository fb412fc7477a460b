// Every primitive of a scene in leaves, in the order of ids: brute force tests them all, the
// textbook tree points into them.
#pragma once

#include <span>
#include <vector>

#include "scene/leaf.h"
#include "scene/scene_view.h"
#include "util/huge_array.h"

namespace dapple {

// Leaves of what stands in the world and of each prototype.
class LeafList {
 public:
  LeafList() = default;
  explicit LeafList(const SceneView& scene);

  std::span<const LeafRef> leaves() const { return std::span(leaves_).first(world_leaf_count_); }
  std::span<const LeafRef> leaves_of_prototype(std::size_t prototype) const;
  const LeafRow* rows() const { return rows_.data(); }
  std::size_t bytes() const { return rows_.bytes() + leaves_.size() * sizeof(leaves_[0]); }

  // Where the primitive with that id stands.
  LeafRef lane_of(PrimId id) const;

 private:
  // Primitives with ids from first_id on, of one kind, in the leaves from first_leaf on.
  struct Group {
    std::size_t first_id = 0, first_leaf = 0;
  };

  void add_group(ShapeKind kind, std::size_t first_id, std::size_t count);

  std::vector<Group> groups_;                // by ascending ids; none is empty
  std::vector<std::size_t> prototype_ends_;  // their leaves follow those of the world
  std::size_t world_leaf_count_ = 0;
  std::size_t row_count_ = 0;
  std::vector<LeafRef> leaves_;
  HugeArray<LeafRow> rows_;
};

}  // namespace dapple
