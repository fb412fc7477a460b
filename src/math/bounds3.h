// Axis-aligned boxes.
#pragma once

#include <limits>

#include "math/vec3.h"

namespace dapple {

struct Bounds3f {
  // Empty: contains nothing, and extending it by a box gives that box.
  Vec3f lo{kInfinity, kInfinity, kInfinity};
  Vec3f hi{-kInfinity, -kInfinity, -kInfinity};

  static constexpr float kInfinity = std::numeric_limits<float>::infinity();

  void extend(const Bounds3f& other) {
    for (int axis = 0; axis < 3; ++axis) {
      lo[axis] = other.lo[axis] < lo[axis] ? other.lo[axis] : lo[axis];
      hi[axis] = other.hi[axis] > hi[axis] ? other.hi[axis] : hi[axis];
    }
  }
  bool contains(const Bounds3f& inner) const {
    return lo.x <= inner.lo.x && lo.y <= inner.lo.y && lo.z <= inner.lo.z && hi.x >= inner.hi.x &&
           hi.y >= inner.hi.y && hi.z >= inner.hi.z;
  }
  // Half the surface area; 0 for an empty box.
  float half_area() const {
    const Vec3f d = hi - lo;
    return d.x < 0 ? 0.0f : d.x * d.y + d.y * d.z + d.z * d.x;
  }
  friend bool operator==(const Bounds3f&, const Bounds3f&) = default;
};

}  // namespace dapple
