// Builds the wide BVH: binned SAH, many children a node, in parallel.
#pragma once

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

}  // namespace dapple
