// Orthonormal bases around a normal.
#pragma once

#include <cmath>

#include "math/vec3.h"

namespace dapple {

// Right-handed; `normal` is the local z axis.
struct Frame {
  Vec3f tangent{1, 0, 0}, bitangent{0, 1, 0}, normal{0, 0, 1};

  Vec3f to_local(const Vec3f& v) const {
    return {dot(v, tangent), dot(v, bitangent), dot(v, normal)};
  }
  Vec3f to_world(const Vec3f& v) const { return v.x * tangent + v.y * bitangent + v.z * normal; }
};

// Any frame around the unit vector n, without a square root and with no direction where it breaks
// [DuffBC17].
inline Frame frame_around(const Vec3f& n) {
  const float sign = n.z < 0.0f ? -1.0f : 1.0f;
  const float a = -1.0f / (sign + n.z);
  const float b = n.x * n.y * a;
  return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

// The frame around the unit vector n whose tangent is as near to `tangent` as can be.
inline Frame frame_along(const Vec3f& n, const Vec3f& tangent) {
  const Vec3f t = tangent - dot(tangent, n) * n;
  const float squared = dot(t, t);
  if (!(squared > 1e-12f)) return frame_around(n);
  const Vec3f unit = t / std::sqrt(squared);
  return {unit, cross(n, unit), n};
}

}  // namespace dapple
