// Figures about a finished wide BVH.
#pragma once

#include "accel/accel.h"
#include "scene/wide_bvh.h"

namespace dapple {

// The union of the boxes of a node's children.
[[nodiscard]] Bounds3f node_bounds(const WideNode& node);

// Everything but the number of primitives.
[[nodiscard]] AccelStats wide_stats(const WideBvhView& bvh);

}  // namespace dapple
