// Light that comes from no surface: lamps without size, and what surrounds the scene.
#pragma once

#include <cstdint>

#include "math/vec3.h"
#include "scene/texture.h"

namespace dapple {

enum class LightKind : std::uint32_t { point, spot, directional };

// As KHR_lights_punctual: `intensity` is radiant intensity (per steradian) for point and spot,
// irradiance at right angles for directional.
struct Light {
  LightKind kind = LightKind::point;
  Vec3f position;
  Vec3f direction{0, 0, -1};  // unit, the way light travels
  Vec3f intensity{1, 1, 1};
  float inner_angle = 0;            // spot: radians from the axis, full light up to here
  float outer_angle = 0.78539816f;  // and none from here on
  friend bool operator==(const Light&, const Light&) = default;
};

enum class EnvironmentKind : std::uint32_t {
  classic_sky,  // the blue sky of the classic scenes, and their light transport
  none,         // black
  constant,     // `colour` from everywhere
  image,        // equirectangular, y up: its centre column lies at +x when unrotated
  studio,       // a neutral studio, generated
};

struct Environment {
  EnvironmentKind kind = EnvironmentKind::classic_sky;
  ImageId image = kNoImage;
  Vec3f colour{1, 1, 1};  // multiplies all kinds but the classic sky
  float rotation = 0;     // degrees about +y
  friend bool operator==(const Environment&, const Environment&) = default;
};

}  // namespace dapple
