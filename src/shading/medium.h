// Homogeneous media: what the inside of a closed surface does to light.
#pragma once

#include "math/vec2.h"
#include "math/vec3.h"

namespace dapple {

// Coefficients per unit of length.
struct Medium {
  Vec3f absorption;
  Vec3f scattering;
  float g = 0;  // mean cosine of Henyey and Greenstein's phase function, in (-1, 1)

  bool scatters() const { return scattering.x > 0 || scattering.y > 0 || scattering.z > 0; }
  bool is_vacuum() const { return !scatters() && absorption == Vec3f(); }
};

// exp(-(absorption + scattering) * distance) by Beer's law; the distance may be infinite.
[[nodiscard]] Vec3f transmittance(const Medium& medium, float distance);

// What happens on the way to a surface `distance` away. The weight is transmittance (times
// scattering) over the density, mixed over the channels' own densities so that no channel has
// large weights.
struct MediumSample {
  bool scattered = false;  // at `distance`; else the path reaches the surface
  float distance = 0;
  Vec3f weight{1, 1, 1};
};
// `u_channel` chooses the colour channel in proportion to the path's throughput.
[[nodiscard]] MediumSample sample_distance(const Medium& medium, float distance, Vec3f throughput,
                                           float u_channel, float u);

// Henyey and Greenstein [HenyeyG41]; `cosine` is between the old and the new way of travel. The
// value is the density over solid angle as well.
[[nodiscard]] float phase(float cosine, float g);
// `direction` is the unit way the light travelled; the result has density phase().
[[nodiscard]] Vec3f sample_phase(const Vec3f& direction, float g, Vec2f u);

}  // namespace dapple
