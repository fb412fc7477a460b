// Lights without size.
#pragma once

#include <optional>

#include "scene/light.h"
#include "shading/light_bounds.h"

namespace dapple {

// A punctual light with what sampling needs worked out.
class Lamp {
 public:
  explicit Lamp(const Light& light);

  struct Arrival {
    Vec3f wi;  // unit, towards the light
    float distance = 0;
    Vec3f irradiance;  // at right angles
  };
  std::optional<Arrival> at(const Vec3f& position) const;

  bool is_directional() const { return light_.kind == LightKind::directional; }
  const Vec3f& intensity() const { return light_.intensity; }
  LightBounds bounds() const;  // not for directional ones

 private:
  Light light_;
  float cos_outer_ = -1, cone_scale_ = 0;
};

}  // namespace dapple
