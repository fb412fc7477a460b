// Four-component tuples: colours with alpha, tangents with a sign, quaternions.
#pragma once

#include "math/vec3.h"

namespace dapple {

struct Vec4f {
  float x = 0, y = 0, z = 0, w = 0;

  constexpr Vec3f xyz() const { return {x, y, z}; }
  friend constexpr bool operator==(const Vec4f&, const Vec4f&) = default;
};

constexpr Vec4f operator+(Vec4f a, Vec4f b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
constexpr Vec4f operator*(float s, Vec4f a) { return {s * a.x, s * a.y, s * a.z, s * a.w}; }

}  // namespace dapple
