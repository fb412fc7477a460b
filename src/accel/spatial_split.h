// Splits of space: what is on both sides of a plane goes to both, each part with a smaller box
// [StichFD09].
#pragma once

#include <optional>
#include <span>

#include "accel/partition.h"
#include "accel/triangle_clipper.h"

namespace dapple {

// Where a range may be split, and what is then on both sides.
struct SpatialSplit {
  int axis = 0;
  int bin = 0;
  float origin = 0, scale = 0;  // bin = truncate((coordinate - origin) * scale)
  float cost = 0;               // by surface areas
  Box4 left, right;
  std::size_t left_count = 0, right_count = 0;

  float plane() const { return origin + static_cast<float>(bin) / scale; }
};

// The best of some planes across the longest axis; none if no plane has primitives on both sides
// and so few on both together that the range has room for them.
[[nodiscard]] std::optional<SpatialSplit> find_spatial_split(const TriangleClipper& clipper,
                                                             std::span<const BuildPrim> prims,
                                                             const PrimRange& range);

// Left side first, each with its boxes and its share of the room that is left.
[[nodiscard]] RangePair partition_spatially(const TriangleClipper& clipper,
                                            std::span<BuildPrim> prims, const PrimRange& range,
                                            const SpatialSplit& split);

// Moves the right of two adjacent sides up, so that each has a share of the room behind it.
[[nodiscard]] RangePair share_room(std::span<BuildPrim> prims, RangePair sides, std::size_t room);

}  // namespace dapple
