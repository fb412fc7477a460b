// Builds the wide BVH: binned SAH, many children a node, in parallel.
#pragma once

#include <vector>

#include "parallel/thread_times.h"
#include "scene/scene_view.h"
#include "scene/wide_bvh.h"
#include "util/huge_array.h"

namespace dapple {

struct WideBvh {
  HugeArray<WideNode> nodes;
  HugeArray<LeafRow> rows;

  WideBvhView view() const { return {nodes.span(), rows.span()}; }
};

// A node is grown by splitting, again and again, the child with the largest surface until it has
// kWideWidth children or only leaves. The tree is the same for any number of threads.
// `times`, if given, gets how long each thread was at work.
[[nodiscard]] WideBvh build_wide_bvh(const SceneView& scene, ThreadTimes* times = nullptr);

// Where the trees of a finished BVH begin: first that of the world, if anything stands in it, then
// those of the prototypes that have triangles.
[[nodiscard]] std::vector<std::uint32_t> tree_roots(std::span<const WideNode> nodes);
// For each prototype the root of its tree, or PlacedInstance::kNothing.
[[nodiscard]] std::vector<std::uint32_t> prototype_roots(const SceneView& scene,
                                                         std::span<const WideNode> nodes);

}  // namespace dapple
