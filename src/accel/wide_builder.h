// Builds the wide BVH: binned SAH, many children a node, in parallel.
#pragma once

#include <vector>

#include "accel/bvh_quality.h"
#include "parallel/thread_times.h"
#include "scene/scene_view.h"
#include "scene/wide_bvh.h"
#include "util/huge_array.h"

namespace dapple {

struct WideBvh {
  HugeArray<WideNode> nodes;
  HugeArray<LeafRow> rows;
  LeafForm form = LeafForm::whole;

  WideBvhView view() const { return {nodes.span(), rows.span(), form}; }
};

// Whether a triangle may be in several leaves, each with a box around the part of it that is there.
// Such trees are for finding hits only: scene files do not hold them.
enum class TriangleParts { none, where_they_pay };

// A small range becomes a binary tree from which wide nodes are chosen; a node above those is grown
// by splitting, again and again, the child with the largest surface until it has kWideWidth
// children or only leaves. The tree is the same for any number of threads. `times`, if given, gets
// how long each thread was at work. Only high quality makes parts of triangles.
[[nodiscard]] WideBvh build_wide_bvh(const SceneView& scene, ThreadTimes* times = nullptr,
                                     BvhQuality quality = BvhQuality::medium,
                                     LeafForm form = LeafForm::whole,
                                     TriangleParts parts = TriangleParts::none);

// Gives a tree of the same scene, whose shapes have moved, their new places: leaves keep what they
// hold, boxes are made anew. Much faster than building; the farther shapes move, the worse the tree
// fits them. Boxes of parts become those of whole triangles. In parallel.
void refit_wide_bvh(const SceneView& scene, WideBvh& bvh);

// Where the trees of a finished BVH begin: first that of the world, if anything stands in it, then
// those of the prototypes that have triangles.
[[nodiscard]] std::vector<std::uint32_t> tree_roots(std::span<const WideNode> nodes);
// For each prototype the root of its tree, or PlacedInstance::kNothing.
[[nodiscard]] std::vector<std::uint32_t> prototype_roots(const SceneView& scene,
                                                         std::span<const WideNode> nodes);

}  // namespace dapple
