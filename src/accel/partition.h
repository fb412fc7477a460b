// Rearranging a range of primitives into the two sides of a split.
#pragma once

#include <span>
#include <utility>

#include "accel/prim_range.h"
#include "accel/sah_split.h"

namespace dapple {

using RangePair = std::pair<PrimRange, PrimRange>;

// Left side first, each with its boxes. `scratch` is as long as `prims`; large ranges use the
// same part of it. The arrangement does not depend on the number of threads.
[[nodiscard]] RangePair partition_range(std::span<BuildPrim> prims, std::span<BuildPrim> scratch,
                                        const PrimRange& range, const SahSplit& split);

}  // namespace dapple
