// A ray segment: origin + t * direction for t in [t_min, t_max].
#pragma once

#include <limits>

#include "math/vec3.h"

namespace dapple {

struct Ray {
  Vec3f origin;
  float t_min = 0;  // hits behind the origin never count: below 0 means 0
  Vec3f direction;  // of any length from 1e-18 to 1e18; t counts in units of it
  float t_max = std::numeric_limits<float>::infinity();

  Vec3f at(float t) const { return origin + t * direction; }
};
static_assert(sizeof(Ray) == 32, "kernels and streams read rays as eight floats");

}  // namespace dapple
