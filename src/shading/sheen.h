// The sheen of cloth: the microfacet distribution and the shadowing of Estevez and Kulla
// [EstevezK17], as KHR_materials_sheen asks.
#pragma once

#include <algorithm>

#include "math/fast_functions.h"
#include "math/vec3.h"

namespace dapple {

class SheenDistribution {
 public:
  static constexpr float kLeastRoughness = 0.1f;  // narrower lobes are seen by none

  explicit SheenDistribution(float roughness) {
    const float r = std::max(roughness, kLeastRoughness);
    const float alpha = r * r;
    inverse_alpha_ = 1.0f / alpha;
    const float t = (1.0f - alpha) * (1.0f - alpha);
    a_ = mix_fit(21.5473f, 25.3245f, t);
    b_ = mix_fit(3.82987f, 3.32435f, t);
    c_ = mix_fit(0.19823f, 0.16801f, t);
    d_ = mix_fit(-1.97760f, -1.27393f, t);
    e_ = mix_fit(-4.32054f, -4.85967f, t);
  }

  // f |cos(wi)| for a white sheen; both directions above the surface.
  float evaluate(const Vec3f& wo, const Vec3f& wi) const {
    const Vec3f h = normalize(wo + wi);
    const float sin2 = std::max(1.0f - h.z * h.z, 0.0f);
    const float d =
        (2.0f + inverse_alpha_) * fast_pow(sin2, 0.5f * inverse_alpha_) * (0.5f * kInvPi);
    const float shadowing = 1.0f / (1.0f + lambda(wo.z) + lambda(wi.z));
    return d * shadowing / (4.0f * std::max(wo.z, 1e-4f));
  }

 private:
  static float mix_fit(float rough, float smooth, float t) { return rough + t * (smooth - rough); }
  float fit(float x) const { return a_ / (1.0f + b_ * fast_pow(x, c_)) + d_ * x + e_; }
  float lambda(float cosine) const {
    return cosine < 0.5f ? fast_exp(fit(cosine)) : fast_exp(2.0f * fit(0.5f) - fit(1.0f - cosine));
  }

  float inverse_alpha_;
  float a_, b_, c_, d_, e_;  // the fit of lambda
};

}  // namespace dapple
