// Directions through an interface; all unit vectors that point away from the surface.
#pragma once

#include <cmath>

#include "math/vec3.h"

namespace dapple {

inline Vec3f reflect_about(const Vec3f& w, const Vec3f& h) { return 2.0f * dot(w, h) * h - w; }

// The direction on the far side of a facet with normal h, dot(w, h) > 0; `eta` is the index of the
// far side over that of the side of w. False where all is reflected.
inline bool refract(const Vec3f& w, const Vec3f& h, float eta, Vec3f& result) {
  const float inverse = 1.0f / eta;
  const float cosine = dot(w, h);
  const float squared = 1.0f - inverse * inverse * (1.0f - cosine * cosine);
  if (!(squared > 0.0f)) return false;
  result = (inverse * cosine - std::sqrt(squared)) * h - inverse * w;
  return true;
}

}  // namespace dapple
