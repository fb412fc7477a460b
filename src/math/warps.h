// Warps of uniform numbers in [0, 1) to the distributions that sampling needs.
#pragma once

#include <cmath>

#include "math/functions.h"
#include "math/vec3.h"

namespace dapple {

// A uniform point of the unit disc in the plane z = 0; density 1 / pi.
inline Vec3f sample_uniform_disc(float u, float v) {
  const float r = std::sqrt(u);
  const SinCos<float> angle = sin_cos_turns(v);
  return {r * angle.cos, r * angle.sin, 0.0f};
}

// A uniform point of the unit sphere; density 1 / (4 pi).
inline Vec3f sample_uniform_sphere(float u, float v) {
  const float z = 1.0f - 2.0f * u;
  const float squared = 1.0f - z * z;
  const float r = std::sqrt(squared > 0.0f ? squared : 0.0f);
  const SinCos<float> angle = sin_cos_turns(v);
  return {r * angle.cos, r * angle.sin, z};
}

// A uniform point of the unit ball; density 3 / (4 pi).
inline Vec3f sample_uniform_ball(float u, float v, float w) {
  return cube_root(w) * sample_uniform_sphere(u, v);
}

// A unit direction around the unit normal n with density cos(theta) / pi: a point of the unit
// sphere that touches the surface, seen from the point of contact.
inline Vec3f sample_cosine_hemisphere(const Vec3f& n, float u, float v) {
  const Vec3f direction = n + sample_uniform_sphere(u, v);
  const float squared = dot(direction, direction);
  return squared > 1e-12f ? direction / std::sqrt(squared) : n;
}

}  // namespace dapple
