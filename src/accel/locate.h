// Where on which surface a hit lies: Accel::locate without the structure around it.
#pragma once

#include "accel/accel.h"
#include "accel/placed_instance.h"

namespace dapple {

// `lane` is that of a hit of the ray at `t`; `instances` are asked only for what is seen through
// one.
[[nodiscard]] SurfacePoint locate_hit(const LeafArrays& leaves, const PlacedInstance* instances,
                                      const Ray& ray, float t, LeafRef lane);

// The same for a kernel, whose numbers are `stride` apart: takes origin, direction and t from
// `numbers` and leaves position, outward normal and error there.
void locate_lane(const LeafArrays& leaves, const PlacedInstance* instances, float* numbers,
                 std::size_t stride, std::uint64_t lane);

}  // namespace dapple
