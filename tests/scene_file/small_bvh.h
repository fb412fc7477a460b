// A BVH for tests of scene files: simple, and as src/scene/wide_bvh.h wants it.
#pragma once

#include <vector>

#include "scene/scene_view.h"

namespace dapple::test {

struct SmallBvh {
  std::vector<WideNode> nodes;
  std::vector<LeafRow> rows;

  WideBvhView view() const { return {nodes, rows}; }
};

// Sorted by centre along x, y and z in turn; `max_children` (2 to 16) of each node and at most
// `max_leaf` primitives of a leaf give trees of different shapes.
[[nodiscard]] SmallBvh build_small_bvh(const SceneView& scene, std::size_t max_children = 4,
                                       std::size_t max_leaf = 3);

}  // namespace dapple::test
