#include "shading/light_bounds.h"

#include <algorithm>
#include <cmath>

#include "math/fast_functions.h"

namespace dapple {
namespace {

struct Angle {
  float cos, sin;
};

Angle angle_of(float cosine) {
  return {cosine, std::sqrt(std::max((1.0f - cosine) * (1.0f + cosine), 0.0f))};
}

// a - b, and zero where b is larger.
Angle minus_clamped(Angle a, Angle b) {
  if (a.cos >= b.cos) return {1, 0};
  return {a.cos * b.cos + a.sin * b.sin, a.sin * b.cos - a.cos * b.sin};
}

Vec3f centre(const Bounds3f& b) { return 0.5f * (b.lo + b.hi); }

}  // namespace

LightBounds merged(const LightBounds& a, const LightBounds& b) {
  if (!(a.power > 0.0f)) return b;
  if (!(b.power > 0.0f)) return a;
  LightBounds result = a;
  result.bounds.extend(b.bounds);
  result.power = a.power + b.power;
  result.cos_spread = 0;
  if (a.cos_spread <= 0.0f || b.cos_spread <= 0.0f) return result;
  const bool a_wider = a.cos_spread < b.cos_spread;
  const LightBounds &wide = a_wider ? a : b, &narrow = a_wider ? b : a;
  const float cosine = dot(wide.axis, narrow.axis);
  const Vec3f other = cosine < 0.0f ? -narrow.axis : narrow.axis;
  const float between = fast_acos(std::fabs(cosine));
  const float wide_spread = fast_acos(wide.cos_spread),
              narrow_spread = fast_acos(narrow.cos_spread);
  result.axis = wide.axis;
  if (between + narrow_spread <= wide_spread) {
    result.cos_spread = wide.cos_spread;
    return result;
  }
  // Rounded up, so that the cone holds both in spite of the angles' errors.
  const float spread = 0.5f * (wide_spread + between + narrow_spread) + 1e-5f;
  if (spread >= 0.5f * kPi) return result;
  // The new axis, in the plane of both: turned from the wider one's.
  const float turn = spread - wide_spread;
  const Vec3f across = other - std::fabs(cosine) * wide.axis;
  const float length2 = dot(across, across);
  if (length2 > 1e-12f) {
    const SinCos<float> t = sin_cos(turn);
    result.axis = normalize(t.cos * wide.axis + (t.sin / std::sqrt(length2)) * across);
  }
  result.cos_spread = sin_cos(spread).cos;
  return result;
}

float importance(const LightBounds& light, const Vec3f& position, const Vec3f& normal) {
  const Vec3f to_light = centre(light.bounds) - position;
  const Vec3f half = 0.5f * (light.bounds.hi - light.bounds.lo);
  const float radius2 = dot(half, half);
  const float distance2 = dot(to_light, to_light);
  // From inside, or on it, any direction is possible.
  if (!(distance2 > radius2)) return light.power / std::max(radius2, 1e-18f);
  const Vec3f wi = to_light / std::sqrt(distance2);
  const Angle subtended = angle_of(std::sqrt(1.0f - radius2 / distance2));
  float result = light.power / distance2;
  if (light.cos_spread > 0.0f) {
    const Angle off_axis = angle_of(std::min(std::fabs(dot(light.axis, wi)), 1.0f));
    const Angle least =
        minus_clamped(minus_clamped(off_axis, angle_of(light.cos_spread)), subtended);
    if (!(least.cos > 0.0f)) return 0;
    result *= least.cos;
  }
  if (dot(normal, normal) > 0.0f) {
    const Angle incidence = angle_of(std::min(std::fabs(dot(normal, wi)), 1.0f));
    result *= std::max(minus_clamped(incidence, subtended).cos, 0.0f);
  }
  return result;
}

}  // namespace dapple
