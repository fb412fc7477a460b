// A ray with what every intersection test would otherwise compute again.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "math/ray.h"

namespace dapple {

// Each vector is followed by a number of its own, so that four lanes can be stored at once.
struct PreparedRay {
  float origin[3];
  float t_min;  // at least 0
  float direction[3];
  float t_max;           // negative when the ray can hit nothing
  float inverse[3];      // of the direction, never zero or infinite
  float inverse_dot;     // 1 / dot(direction, direction)
  float inverse_far[3];  // a little more: by this, boxes are left (see kFarPad)
  std::uint32_t axis;    // of the largest component of the direction: the z of the ray's own frame
  float shear[2];        // how far the ray goes along the x and y of that frame for one step of z
};

// Whether a ray passes a triangle is computed otherwise than whether it passes a box, with other
// roundings. So that no box turns away a ray that meets a triangle in it, even at the very edge,
// rays leave boxes this much later: many times the rounding of either [Ize13].
inline constexpr float kFarPad = 1.0f + 0x1p-18f;

// The axes of a ray's own frame.
inline std::uint32_t next_axis(std::uint32_t axis) { return axis == 2 ? 0 : axis + 1; }

// A component below this in magnitude is treated as this large where it is divided by: distances
// to planes stay finite for coordinates up to 1e18, so that no test ever sees a NaN.
inline constexpr float kSmallestDirection = 1e-18f;

inline float safe_inverse(float d) {
  return 1.0f / (std::fabs(d) < kSmallestDirection ? std::copysign(kSmallestDirection, d) : d);
}

// Rays whose numbers sum up to more overflow and hit nothing.
inline constexpr float kLargestUsable = std::numeric_limits<float>::max();

// kernels/prepare-inl.h does the same for many rays at once.
inline PreparedRay prepare(const Ray& ray) {
  PreparedRay prepared;
  for (int axis = 0; axis < 3; ++axis) {
    prepared.origin[axis] = ray.origin[axis];
    prepared.direction[axis] = ray.direction[axis];
    prepared.inverse[axis] = safe_inverse(ray.direction[axis]);
    prepared.inverse_far[axis] = prepared.inverse[axis] * kFarPad;
  }
  const float squared = dot(ray.direction, ray.direction);
  const float origin_size =
      std::fabs(ray.origin.x) + std::fabs(ray.origin.y) + std::fabs(ray.origin.z);
  prepared.inverse_dot = 1.0f / squared;
  prepared.t_min = ray.t_min > 0.0f ? ray.t_min : 0.0f;
  // Also false where one of them is not a number, which no search could end on.
  const bool usable = squared > 0.0f && squared <= kLargestUsable &&
                      origin_size <= kLargestUsable && ray.t_max >= prepared.t_min;
  prepared.t_max = usable ? ray.t_max : -1.0f;

  const float x = std::fabs(ray.direction.x), y = std::fabs(ray.direction.y);
  const float z = std::fabs(ray.direction.z);
  prepared.axis = x >= y ? (x >= z ? 0u : 2u) : (y >= z ? 1u : 2u);
  const std::uint32_t kx = next_axis(prepared.axis), ky = next_axis(kx);
  prepared.shear[0] = prepared.direction[kx] * prepared.inverse[prepared.axis];
  prepared.shear[1] = prepared.direction[ky] * prepared.inverse[prepared.axis];
  return prepared;
}

}  // namespace dapple
