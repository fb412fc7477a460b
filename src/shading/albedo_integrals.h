// Directional albedos by numerical integration: where the tables of albedo_tables.h come from,
// and what they are tested against. Too slow for rendering.
#pragma once

#include "math/vec3.h"

namespace dapple {

// A point of view: the cosine of its angle to the normal, in (0, 1], and the surface's roughness.
// `grid` squared is the number of samples.

// The albedo of a reflecting interface is f0 * scale + f90 * bias for Schlick's Fresnel term.
struct SplitAlbedo {
  double scale = 0, bias = 0;
};
[[nodiscard]] SplitAlbedo integrate_reflection(float cosine, float roughness, int grid);

// Of an interface as rough as `along` in one direction and `across` at right angles to it;
// `azimuth` is the cosine between the first and the view, seen from above.
[[nodiscard]] SplitAlbedo integrate_brushed(float cosine, float azimuth, float along, float across,
                                            int grid);

// Of a rough refracting interface, reflection and transmission together: what single scattering
// leaves of 1.
[[nodiscard]] double integrate_refraction(float cosine, float roughness, float eta, int grid);

[[nodiscard]] double integrate_sheen(float cosine, float roughness, int grid);

}  // namespace dapple
