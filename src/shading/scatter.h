// How the classic materials scatter a ray.
#pragma once

#include <array>
#include <optional>

#include "math/vec3.h"
#include "scene/material.h"

namespace dapple {

// Where and how a ray meets a surface.
struct Encounter {
  Vec3f direction;           // unit, towards the surface
  Vec3f normal;              // unit, on the side the ray came from
  bool from_outside = true;  // the side the outward normal points to
};

struct Scattered {
  Vec3f direction;    // away from the surface; not of unit length for a metal
  Vec3f attenuation;  // what light arriving along `direction` is multiplied by
};

// No value when the ray is absorbed. `u` are uniform numbers in [0, 1).
[[nodiscard]] std::optional<Scattered> scatter(const Material& material, const Encounter& encounter,
                                               const std::array<float, 4>& u);

// Fraction of light that a dielectric reflects by Schlick's approximation [Schlick94]; `cosine` is
// that of the larger of the two angles to the normal, in the thinner medium.
[[nodiscard]] float schlick_reflectance(float cosine, float ref_idx);

}  // namespace dapple
