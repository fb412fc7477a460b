// Where to split a range: the binned surface area heuristic [Wald07].
#pragma once

#include <optional>
#include <span>

#include "accel/bvh_quality.h"
#include "accel/prim_range.h"
#include "scene/leaf.h"

namespace dapple {

// Primitives whose bin along `axis` is below `bin` go left.
struct SahSplit {
  int axis = 0;
  int bin = 0;
  float origin = 0, scale = 0;  // bin = truncate((twice centre - origin) * scale)
  float cost = 0;               // by surface areas, not at low quality
  float overlap = 0;  // half the surface area of what both sides share, only at high quality

  bool goes_left(const BuildPrim& prim) const {
    const float centre = prim.lo[axis] + prim.hi[axis];
    return static_cast<int>((centre - origin) * scale) < bin;
  }
};

// Cost of a leaf, or of what becomes of this many primitives: leaves are tested in blocks.
inline float leaf_cost(std::size_t count) {
  return static_cast<float>((count + kLeafWidth - 1) / kLeafWidth);
}

// The best split of the three axes, or at low quality the middle of the longest; none when all
// centres coincide.
[[nodiscard]] std::optional<SahSplit> find_split(std::span<const BuildPrim> prims,
                                                 const PrimRange& range, BvhQuality quality);

}  // namespace dapple
