// Cylinders, one at a time and in double precision.
#pragma once

#include "accel/prepared_ray.h"

namespace dapple {

// `numbers` are both ends and the radius. The distance of the hit in [t_min, t_max], or a negative
// number; the own-box rule (intersect_scalar.h) is part of it. All kernels call this one.
[[nodiscard]] float intersect_cylinder(const PreparedRay& ray, const float numbers[7], float t_max);

}  // namespace dapple
