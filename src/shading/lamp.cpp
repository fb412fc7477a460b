#include "shading/lamp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/fast_functions.h"
#include "shading/colour.h"

namespace dapple {

Lamp::Lamp(const Light& light) : light_(light) {
  if (light.kind != LightKind::spot) return;
  cos_outer_ = sin_cos(light.outer_angle).cos;
  cone_scale_ = 1.0f / std::max(sin_cos(light.inner_angle).cos - cos_outer_, 1e-3f);
}

std::optional<Lamp::Arrival> Lamp::at(const Vec3f& position) const {
  if (is_directional()) {
    return Arrival{-light_.direction, std::numeric_limits<float>::infinity(), light_.intensity};
  }
  const Vec3f to_light = light_.position - position;
  const float squared = dot(to_light, to_light);
  if (!(squared > 0.0f)) return std::nullopt;
  const float distance = std::sqrt(squared);
  const Vec3f wi = to_light / distance;
  float cone = 1;
  if (light_.kind == LightKind::spot) {
    // The falloff that KHR_lights_punctual recommends.
    const float t = (-dot(wi, light_.direction) - cos_outer_) * cone_scale_;
    if (!(t > 0.0f)) return std::nullopt;
    cone = t < 1.0f ? t * t : 1.0f;
  }
  return Arrival{wi, distance, (cone / squared) * light_.intensity};
}

LightBounds Lamp::bounds() const {
  LightBounds result;
  result.bounds = {light_.position, light_.position};
  result.cos_spread = 0;
  result.power = luminance(light_.intensity);
  return result;
}

}  // namespace dapple
