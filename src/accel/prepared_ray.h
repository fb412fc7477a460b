// A ray with what every intersection test would otherwise compute again.
#pragma once

#include <cmath>

#include "math/ray.h"

namespace dapple {

struct PreparedRay {
  float origin[3];
  float direction[3];
  float inverse[3];   // of the direction, never zero or infinite
  float t_min;        // at least 0
  float t_max;        // below t_min when the ray can hit nothing
  float inverse_dot;  // 1 / dot(direction, direction)
};

// A component below this in magnitude is treated as this large where it is divided by: distances
// to planes stay finite for coordinates up to 1e18, so that no test ever sees a NaN.
inline constexpr float kSmallestDirection = 1e-18f;

inline float safe_inverse(float d) {
  return 1.0f / (std::fabs(d) < kSmallestDirection ? std::copysign(kSmallestDirection, d) : d);
}

inline PreparedRay prepare(const Ray& ray) {
  const float squared = dot(ray.direction, ray.direction);
  PreparedRay prepared;
  for (int axis = 0; axis < 3; ++axis) {
    prepared.origin[axis] = ray.origin[axis];
    prepared.direction[axis] = ray.direction[axis];
    prepared.inverse[axis] = safe_inverse(ray.direction[axis]);
  }
  prepared.inverse_dot = 1.0f / squared;
  prepared.t_min = ray.t_min > 0.0f ? ray.t_min : 0.0f;
  // The last condition also refuses NaN, which no search could end on.
  const bool usable = is_finite(ray.origin) && squared > 0.0f && std::isfinite(squared) &&
                      ray.t_max >= prepared.t_min;
  prepared.t_max = usable ? ray.t_max : -1.0f;
  return prepared;
}

}  // namespace dapple
