// The microfacet distribution of Trowbridge and Reitz [WalterMLT07], anisotropic, with Smith's
// height-correlated shadowing. Directions are local, the normal is z.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/fast_functions.h"
#include "math/vec2.h"
#include "math/vec3.h"

namespace dapple {

struct MicrofacetDistribution {
  float alpha_x = 1, alpha_y = 1;

  // Density of normals per projected area; integrates with cos(h) to 1.
  float d(const Vec3f& h) const {
    const float x = h.x / alpha_x, y = h.y / alpha_y;
    const float s = x * x + y * y + h.z * h.z;
    return kInvPi / (alpha_x * alpha_y * s * s);
  }
  float lambda(const Vec3f& w) const {
    const float x = alpha_x * w.x, y = alpha_y * w.y;
    const float z2 = w.z * w.z;
    return z2 > 0.0f ? 0.5f * (std::sqrt(1.0f + (x * x + y * y) / z2) - 1.0f) : 1e18f;
  }
  // The part of normals that is seen from w, and from both sides of a scattering.
  float g1(const Vec3f& w) const { return 1.0f / (1.0f + lambda(w)); }
  float g2(const Vec3f& wo, const Vec3f& wi) const {
    return 1.0f / (1.0f + lambda(wo) + lambda(wi));
  }
  // Density of visible normals seen from w, w.z > 0, over solid angle.
  float visible_density(const Vec3f& w, const Vec3f& h) const {
    return g1(w) * d(h) * std::max(dot(w, h), 0.0f) / w.z;
  }
  // A visible normal: the spherical cap of Dupuy and Benyoub [DupuyB23].
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

}  // namespace dapple
