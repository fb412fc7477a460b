// A ray with what every intersection test would otherwise compute again.
#pragma once

#include <cmath>
#include <limits>

#include "math/ray.h"

namespace dapple {

// Each vector is followed by a number of its own, so that four lanes can be stored at once.
struct PreparedRay {
  float origin[3];
  float t_min;  // at least 0
  float direction[3];
  float t_max;        // negative when the ray can hit nothing
  float inverse[3];   // of the direction, never zero or infinite
  float inverse_dot;  // 1 / dot(direction, direction)
};

// A component below this in magnitude is treated as this large where it is divided by: distances
// to planes stay finite for coordinates up to 1e18, so that no test ever sees a NaN.
inline constexpr float kSmallestDirection = 1e-18f;

inline float safe_inverse(float d) {
  return 1.0f / (std::fabs(d) < kSmallestDirection ? std::copysign(kSmallestDirection, d) : d);
}

// The numbers that are not vectors.
inline void prepare_scalars(const Ray& ray, PreparedRay& prepared) {
  const float squared = dot(ray.direction, ray.direction);
  const float origin_size =
      std::fabs(ray.origin.x) + std::fabs(ray.origin.y) + std::fabs(ray.origin.z);
  prepared.inverse_dot = 1.0f / squared;
  prepared.t_min = ray.t_min > 0.0f ? ray.t_min : 0.0f;
  // Also false where one of them is not a number, which no search could end on.
  const bool usable = squared > 0.0f && squared <= std::numeric_limits<float>::max() &&
                      origin_size <= std::numeric_limits<float>::max() &&
                      ray.t_max >= prepared.t_min;
  prepared.t_max = usable ? ray.t_max : -1.0f;
}

inline PreparedRay prepare(const Ray& ray) {
  PreparedRay prepared;
  for (int axis = 0; axis < 3; ++axis) {
    prepared.origin[axis] = ray.origin[axis];
    prepared.direction[axis] = ray.direction[axis];
    prepared.inverse[axis] = safe_inverse(ray.direction[axis]);
  }
  prepare_scalars(ray, prepared);
  return prepared;
}

}  // namespace dapple
