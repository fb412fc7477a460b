// How much memory the parts of a scene take.
#pragma once

#include <cstdint>

#include "scene/scene_view.h"

namespace dapple {

// Bytes of the arrays and of that part of the BVH, if there is one, in which the things are: its
// leaves of their kind, and for each leaf the same share of the nodes. 0 of what there is none.
struct Footprint {
  double per_triangle = 0;  // with the vertices
  double per_instance = 0;
  std::uint64_t total = 0;  // of everything, texels too
};
[[nodiscard]] Footprint footprint_of(const SceneView& scene);

}  // namespace dapple
