#include "tests/reference/reference_materials.h"

#include <algorithm>
#include <cmath>

namespace dapple::test {
namespace {

struct Surface {
  Triple incoming;  // unit
  Triple normal;    // unit, on the side the ray came from
  bool outside;
};

using Scattering = std::optional<ReferenceScattering>;

Triple albedo_of(const Vec3d& albedo) { return {albedo.x, albedo.y, albedo.z}; }

Triple mirrored(const Surface& at) {
  return at.incoming - 2 * inner(at.incoming, at.normal) * at.normal;
}

Scattering scatter_from(const Lambertian& m, const Surface& at, ReferenceRandom& random) {
  return ReferenceScattering{at.normal + unit(random_in_ball(random)), albedo_of(m.albedo)};
}

Scattering scatter_from(const Metal& m, const Surface& at, ReferenceRandom& random) {
  const Triple direction = mirrored(at) + m.fuzz * random_in_ball(random);
  if (inner(direction, at.normal) <= 0) return std::nullopt;
  return ReferenceScattering{direction, albedo_of(m.albedo)};
}

// With the angles of incidence and refraction; Schlick's formula takes the larger of the two,
// which is the one in the optically thinner medium.
Scattering scatter_from(const Dielectric& m, const Surface& at, ReferenceRandom& random) {
  const Triple white = {1, 1, 1};
  const double ratio = at.outside ? 1 / m.ref_idx : m.ref_idx;
  const double incidence = std::acos(std::min(1.0, -inner(at.incoming, at.normal)));
  const double sine = ratio * std::sin(incidence);
  if (sine > 1) return ReferenceScattering{mirrored(at), white};
  const double refraction = std::asin(sine);
  const double head_on = std::pow((m.ref_idx - 1) / (m.ref_idx + 1), 2);
  const double larger = std::max(incidence, refraction);
  const double reflected = head_on + (1 - head_on) * std::pow(1 - std::cos(larger), 5);
  if (random_number(random) < reflected) return ReferenceScattering{mirrored(at), white};
  const Triple along = at.incoming + std::cos(incidence) * at.normal;  // of length sin(incidence)
  return ReferenceScattering{ratio * along - std::cos(refraction) * at.normal, white};
}

Scattering scatter_from(const Layered&, const Surface&, ReferenceRandom&) { return std::nullopt; }

}  // namespace

double random_number(ReferenceRandom& random) {
  return std::uniform_real_distribution<double>(0, 1)(random);
}

Triple random_in_disc(ReferenceRandom& random) {
  while (true) {
    const Triple p = {2 * random_number(random) - 1, 2 * random_number(random) - 1, 0};
    if (inner(p, p) < 1) return p;
  }
}

Triple random_in_ball(ReferenceRandom& random) {
  while (true) {
    const Triple p = {2 * random_number(random) - 1, 2 * random_number(random) - 1,
                      2 * random_number(random) - 1};
    if (inner(p, p) < 1) return p;
  }
}

std::optional<ReferenceScattering> scatter_reference(const ReferenceHit& hit,
                                                     const Triple& direction,
                                                     ReferenceRandom& random) {
  const bool outside = inner(direction, hit.outward) < 0;
  const Surface at = {unit(direction), outside ? hit.outward : -1 * hit.outward, outside};
  return std::visit([&](const auto& m) { return scatter_from(m, at, random); }, *hit.material);
}

}  // namespace dapple::test
