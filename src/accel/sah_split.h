// Where to split a range: the binned surface area heuristic [Wald07].
#pragma once

#include <optional>
#include <span>

#include "accel/bvh_quality.h"
#include "accel/prim_range.h"

namespace dapple {

// Primitives whose bin along `axis` is below `bin` go left.
struct SahSplit {
  int axis = 0;
  int bin = 0;
  float origin = 0, scale = 0;  // bin = truncate((twice centre - origin) * scale)

  bool goes_left(const BuildPrim& prim) const {
    const float centre = prim.lo[axis] + prim.hi[axis];
    return static_cast<int>((centre - origin) * scale) < bin;
  }
};

// The best split of the three axes, or at low quality the middle of the longest; none when all
// centres coincide.
[[nodiscard]] std::optional<SahSplit> find_split(std::span<const BuildPrim> prims,
                                                 const PrimRange& range, BvhQuality quality);

}  // namespace dapple
