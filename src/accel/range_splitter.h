// The primitives of a scene while a tree is built over them: ranges are split in place.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "accel/bvh_quality.h"
#include "accel/partition.h"
#include "accel/prim_range.h"
#include "accel/spatial_split.h"
#include "scene/scene_view.h"
#include "util/huge_array.h"

namespace dapple {

enum class SplitBy {
  sah,     // the surface area heuristic; in half where it finds nothing
  number,  // in half, for trees that are getting too deep
};

// Primitives from which on a build takes more memory than one wants to see twice.
inline constexpr std::size_t kGivesBackFrom = std::size_t{1} << 22;

class RangeSplitter {
 public:
  // Of those primitives of the scene, which must outlive this, as must the boxes of prototypes.
  RangeSplitter(const SceneView& scene, const PrototypeBoxes& prototypes,
                HugeArray<BuildPrim> prims, BvhQuality quality, LeafForm form);

  bool can_split_any(const PrimRange& range, const TriangleClipper& clipper) const;
  // A range of them again, with room for parts of triangles: splits of its whole may put a triangle
  // on both sides. The clipper must outlive the result.
  [[nodiscard]] RangeSplitter with_room(const PrimRange& range,
                                        const TriangleClipper& clipper) const;

  // All that there is to split.
  PrimRange whole() const;

  // A leaf holds at most kLeafWidth primitives of one kind. Cheap to ask again and again.
  bool is_leaf(const PrimRange& range) const;
  // Rearranges the primitives of a range that is not a leaf. Ranges that do not overlap may be
  // split at the same time.
  RangePair split(const PrimRange& range, SplitBy by);

  // Writes the primitives of a leaf into its rows, by ascending id; parts of a triangle once.
  ShapeKind leaf_kind(const PrimRange& range) const { return kind_of(prims_[range.begin].id); }
  void write_leaf(const PrimRange& range, LeafRow* leaf) const;
  LeafForm leaf_form() const { return form_; }

  // Gives the memory of a range back whose leaves are all written, in builds so large that this is
  // worth a tenth of their time.
  bool gives_back() const { return prims_.size() >= kGivesBackFrom; }
  void forget(const PrimRange& range) noexcept;

 private:
  ShapeKind kind_of(PrimId id) const;
  RangePair cut(const PrimRange& range, std::size_t middle) const;
  RangePair split_by_id(const PrimRange& range);
  // Instead of the best split that leaves primitives whole.
  std::optional<SpatialSplit> worthwhile_spatial_split(const PrimRange& range,
                                                       const SahSplit& other) const;

  const SceneView& scene_;
  const PrototypeBoxes& prototypes_;
  std::array<std::size_t, kShapeKindCount> first_ids_;
  BvhQuality quality_;
  LeafForm form_;
  HugeArray<BuildPrim> prims_;
  std::size_t room_ = 0;  // behind the primitives, for parts of triangles
  const TriangleClipper* clipper_ = nullptr;
  HugeArray<BuildPrim> scratch_;  // for ranges that several threads split together
};

}  // namespace dapple
