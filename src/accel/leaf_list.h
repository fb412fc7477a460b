// Every primitive of a scene in leaves, in the order of ids: brute force tests them all, the
// textbook tree points into them.
#pragma once

#include <span>
#include <vector>

#include "scene/leaf.h"
#include "scene/scene_view.h"
#include "util/huge_array.h"

namespace dapple {

class LeafList {
 public:
  LeafList() = default;
  explicit LeafList(const SceneView& scene);

  std::span<const LeafRef> leaves() const { return leaves_; }
  const LeafRow* rows() const { return rows_.data(); }
  std::size_t bytes() const { return rows_.bytes() + leaves_.size() * sizeof(leaves_[0]); }

  // Where the primitive with that id stands.
  LeafRef lane_of(PrimId id) const;

 private:
  std::array<std::size_t, kShapeKindCount> first_ids_{};
  std::array<std::size_t, kShapeKindCount> first_leaves_{};  // of each kind
  std::vector<LeafRef> leaves_;
  HugeArray<LeafRow> rows_;
};

}  // namespace dapple
