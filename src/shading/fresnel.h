// What part of light an interface reflects.
#pragma once

#include <cmath>

namespace dapple {

// (1 - cosine)^5 [Schlick94].
inline float schlick_weight(float cosine) {
  const float c = cosine < 1.0f ? 1.0f - cosine : 0.0f;
  const float c2 = c * c;
  return c2 * c2 * c;
}

// At normal incidence, for an index of refraction relative to outside; 1 for 0.
inline float f0_of_ior(float ior) {
  const float root = (ior - 1.0f) / (ior + 1.0f);
  return root * root;
}

// Fresnel's equations for unpolarised light and the cosine >= 0 of incidence; `eta` is the index
// of the far side over that of the near one. 1 where all is reflected.
inline float fresnel_dielectric(float cosine, float eta) {
  const float g2 = eta * eta - 1.0f + cosine * cosine;
  if (!(g2 > 0.0f)) return 1.0f;
  const float g = std::sqrt(g2);
  const float a = (g - cosine) / (g + cosine);
  const float b = ((g + cosine) * cosine - 1.0f) / ((g - cosine) * cosine + 1.0f);
  return 0.5f * a * a * (1.0f + b * b);
}

}  // namespace dapple
