// Where a group of lights is and which ways it shines: what the light tree knows of it
// [ContyK18].
#pragma once

#include "math/bounds3.h"
#include "math/vec3.h"

namespace dapple {

// Emission is symmetric: a light that shines along a direction shines along its opposite.
struct LightBounds {
  Bounds3f bounds;
  Vec3f axis{0, 0, 1};   // unit; of the cone that the normals lie in, up to their sign
  float cos_spread = 1;  // of the cone's half angle; 0 or less: all directions
  float power = 0;       // intensity along the normal
};

// The smallest that holds both, nearly.
[[nodiscard]] LightBounds merged(const LightBounds& a, const LightBounds& b);

// A bound on the irradiance at a point, nearly: power over squared distance, times the largest
// cosines possible at the light and, where `normal` is not zero, at the point. Zero only where
// nothing can arrive.
[[nodiscard]] float importance(const LightBounds& light, const Vec3f& position,
                               const Vec3f& normal);

}  // namespace dapple
