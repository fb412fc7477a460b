// The microfacet distribution of Trowbridge and Reitz [WalterMLT07], with Smith's
// height-correlated shadowing [Heitz14]. Directions are local, the normal is z.
//
//   d       density of facet normals per projected area: with cos(h) it integrates to 1
//   lambda  1 / (1 + lambda(w)) of the facets that face w are seen from there, and
//           1 / (1 + lambda(wo) + lambda(wi)) from both sides of a scattering
//
// Normals are sampled as they are seen from w: with density d(h) dot(w, h) / (w.z (1 + lambda(w))).
#pragma once

#include <algorithm>
#include <cmath>

#include "math/fast_functions.h"
#include "math/vec2.h"
#include "math/vec3.h"

namespace dapple {

struct MicrofacetDistribution {
  // Narrower distributions are taken as mirrors.
  static constexpr float kMirrorAlpha = 1e-4f;

  float alpha_x = 1, alpha_y = 1;

  float d(const Vec3f& h) const {
    const float x = h.x / alpha_x, y = h.y / alpha_y;
    const float s = x * x + y * y + h.z * h.z;
    return kInvPi / (alpha_x * alpha_y * s * s);
  }

  float lambda(const Vec3f& w) const {
    const float x = alpha_x * w.x, y = alpha_y * w.y;
    const float z2 = std::max(w.z * w.z, 1e-18f);
    return 0.5f * (std::sqrt(1.0f + (x * x + y * y) / z2) - 1.0f);
  }

  // The part of a spherical cap that Dupuy and Benyoub [DupuyB23] found visible normals to be.
  Vec3f sample(const Vec3f& w, Vec2f u) const {
    const Vec3f stretched = normalize(Vec3f(alpha_x * w.x, alpha_y * w.y, w.z));
    const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
    const float squared = (1.0f - z) * (1.0f + z);
    const float r = squared > 0.0f ? std::sqrt(squared) : 0.0f;
    const SinCos<float> angle = sin_cos_turns(u.x);
    const Vec3f h = Vec3f(r * angle.cos, r * angle.sin, z) + stretched;
    return normalize(Vec3f(alpha_x * h.x, alpha_y * h.y, std::max(h.z, 1e-7f)));
  }
};

// The same by angles to the normal alone.
class IsotropicMicrofacets {
 public:
  explicit IsotropicMicrofacets(float alpha) : alpha2_(alpha * alpha) {}

  // By the square of the sine: that of a small angle's cosine has too few digits.
  float d(float sin2) const {
    const float s = sin2 + alpha2_ * (1.0f - sin2);
    return kInvPi * alpha2_ / (s * s);
  }
  float lambda(float cosine) const {
    const float z2 = std::max(cosine * cosine, 1e-18f);
    return 0.5f * (std::sqrt(1.0f + alpha2_ * std::max(1.0f - z2, 0.0f) / z2) - 1.0f);
  }

 private:
  float alpha2_;
};

}  // namespace dapple
