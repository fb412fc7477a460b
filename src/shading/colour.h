// Measures of linear colours.
#pragma once

#include "math/vec3.h"

namespace dapple {

// Of Rec. 709 primaries.
constexpr float luminance(const Vec3f& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

constexpr float max_component(const Vec3f& c) {
  const float xy = c.x > c.y ? c.x : c.y;
  return xy > c.z ? xy : c.z;
}

constexpr Vec3f mix(const Vec3f& a, const Vec3f& b, float t) { return a + t * (b - a); }
constexpr float mix(float a, float b, float t) { return a + t * (b - a); }
constexpr Vec3f grey(float value) { return {value, value, value}; }

}  // namespace dapple
