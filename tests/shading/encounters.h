// Encounters of rays with surfaces, for tests of materials.
#pragma once

#include <cmath>
#include <cstdint>

#include "math/random.h"
#include "math/warps.h"
#include "shading/scatter.h"

namespace dapple::test {

// Two unit vectors that make a right-handed frame with the unit normal n.
struct Tangents {
  Vec3d along;  // the part of the incoming direction along the surface, where it has one
  Vec3d across;
};

inline Tangents tangents(const Vec3d& n, const Vec3d& incoming) {
  Vec3d along = incoming - dot(incoming, n) * n;
  if (length(along) < 1e-6)
    along = cross(n, std::fabs(n.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0));
  along = normalize(along);
  return {along, cross(n, along)};
}

inline Vec3f random_normal(std::uint32_t i) {
  const auto u = uniform4(i, 0, 0, 0, 77);
  return sample_uniform_sphere(u[0], u[1]);
}

// A ray that meets the surface at that angle to its normal, whose cosine is given.
inline Encounter encounter_at(const Vec3f& normal, double cosine, bool from_outside = true) {
  const Vec3d n(normal);
  const Vec3d along = tangents(n, {0.3, -0.5, 0.7}).along;
  const double sine = std::sqrt(std::fmax(0, 1 - cosine * cosine));
  return {Vec3f(normalize(sine * along - cosine * n)), normal, from_outside};
}

}  // namespace dapple::test
