#include "shading/thin_film.h"

#include <algorithm>
#include <cmath>

#include "math/fast_functions.h"
#include "shading/colour.h"
#include "shading/fresnel.h"

namespace dapple {
namespace {

// Rec. 709 values of a spectral reflectance 1 + cos(optical path difference): Gaussian fits of the
// colour matching functions in the Fourier domain.
Vec3f sensitivity(float opd_nm, const Vec3f& shift) {
  const float phase = 2.0f * kPi * opd_nm * 1.0e-9f;
  const auto gaussian = [&](float value, float position, float variance, float channel_shift) {
    return value * std::sqrt(2.0f * kPi * variance) *
           sin_cos(position * phase + channel_shift).cos * fast_exp(-phase * phase * variance);
  };
  constexpr float kScale = 1.0f / 1.0685e-7f;
  const float x = kScale * (gaussian(5.4856e-13f, 1.6810e+06f, 4.3278e+09f, shift.x) +
                            gaussian(9.7470e-14f, 2.2399e+06f, 4.5282e+09f, shift.x));
  const float y = kScale * gaussian(4.4201e-13f, 1.7953e+06f, 9.3046e+09f, shift.y);
  const float z = kScale * gaussian(5.2481e-13f, 2.2084e+06f, 6.6121e+09f, shift.z);
  return {3.2404542f * x - 1.5371385f * y - 0.4985314f * z,
          -0.9692660f * x + 1.8760108f * y + 0.0415560f * z,
          0.0556434f * x - 0.2040259f * y + 1.0572252f * z};
}

float ior_of_f0(float f0) {
  const float root = std::sqrt(std::min(f0, 0.9999f));
  return (1.0f + root) / (1.0f - root);
}

float phase_shift(float near_ior, float far_ior) { return far_ior < near_ior ? kPi : 0.0f; }

}  // namespace

Vec3f thin_film_reflectance(float cosine, float film_ior, float thickness_nm,
                            const Vec3f& base_f0) {
  // A film that vanishes has the index of what is around it.
  const float t = std::clamp(thickness_nm / 0.03f, 0.0f, 1.0f);
  const float ior = mix(1.0f, film_ior, t * t * (3.0f - 2.0f * t));
  const float cos2 = 1.0f - (1.0f - cosine * cosine) / (ior * ior);
  if (!(cos2 > 0.0f)) return {1, 1, 1};
  const float inside = std::sqrt(cos2);

  // The two interfaces.
  const float outer_f0 = f0_of_ior(ior);
  const float r12 = outer_f0 + (1.0f - outer_f0) * schlick_weight(cosine);
  const float t121 = 1.0f - r12;
  const float phi21 = kPi - phase_shift(1.0f, ior);
  Vec3f r23, phi;
  for (int c = 0; c < 3; ++c) {
    const float base_ior = ior_of_f0(base_f0[c]);
    const float relative = f0_of_ior(base_ior / ior);
    r23[c] = relative + (1.0f - relative) * schlick_weight(inside);
    phi[c] = phi21 + phase_shift(ior, base_ior);
  }
  const float opd = 2.0f * ior * thickness_nm * inside;

  // The series of reflections inside the film: its mean, then two harmonics.
  Vec3f result, harmonic, ratio;
  for (int c = 0; c < 3; ++c) {
    const float r123 = std::clamp(r12 * r23[c], 1e-5f, 0.9999f);
    ratio[c] = std::sqrt(r123);
    const float rs = t121 * t121 * r23[c] / (1.0f - r123);
    result[c] = r12 + rs;
    harmonic[c] = rs - t121;
  }
  for (int m = 1; m <= 2; ++m) {
    harmonic = harmonic * ratio;
    const auto order = static_cast<float>(m);
    result = result + 2.0f * harmonic * sensitivity(order * opd, order * phi);
  }
  return {std::clamp(result.x, 0.0f, 1.0f), std::clamp(result.y, 0.0f, 1.0f),
          std::clamp(result.z, 0.0f, 1.0f)};
}

}  // namespace dapple
