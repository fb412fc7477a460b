#include "textbook/scatter.h"

#include <cmath>

namespace dapple::textbook {
namespace {

Vec3d reflect(const Vec3d& d, const Vec3d& n) { return d - 2 * dot(d, n) * n; }

std::optional<Scattered> scatter_from(const Lambertian& material, const HitRecord& at, const Vec3d&,
                                      Random& random) {
  Vec3d direction = at.normal + normalize(random_in_unit_ball(random));
  if (dot(direction, direction) < 1e-16) direction = at.normal;
  return Scattered{direction, material.albedo};
}

std::optional<Scattered> scatter_from(const Metal& material, const HitRecord& at, const Vec3d& unit,
                                      Random& random) {
  const Vec3d direction = reflect(unit, at.normal) + material.fuzz * random_in_unit_ball(random);
  if (dot(direction, at.normal) <= 0) return std::nullopt;
  return Scattered{direction, material.albedo};
}

double schlick(double cosine, double ref_idx) {
  const double root = (1 - ref_idx) / (1 + ref_idx);
  return root * root + (1 - root * root) * std::pow(1 - cosine, 5);
}

std::optional<Scattered> scatter_from(const Dielectric& material, const HitRecord& at,
                                      const Vec3d& unit, Random& random) {
  const double eta = at.from_outside ? 1 / material.ref_idx : material.ref_idx;
  const double cos_in = std::fmin(-dot(unit, at.normal), 1.0);
  const double sin2_out = eta * eta * (1 - cos_in * cos_in);
  const double cos_out = std::sqrt(std::fmax(0.0, 1 - sin2_out));
  const double cos_in_thinner = eta < 1 ? cos_in : cos_out;
  const bool reflects = sin2_out > 1 || random.next() < schlick(cos_in_thinner, material.ref_idx);
  const Vec3d direction =
      reflects ? reflect(unit, at.normal) : eta * unit + (eta * cos_in - cos_out) * at.normal;
  return Scattered{direction, {1, 1, 1}};
}
std::optional<Scattered> scatter_from(const Layered&, const HitRecord&, const Vec3d&, Random&) {
  return std::nullopt;
}

}  // namespace

std::optional<Scattered> scatter(const HitRecord& at, const Vec3d& direction, Random& random) {
  const Vec3d unit = normalize(direction);
  return std::visit([&](const auto& m) { return scatter_from(m, at, unit, random); }, *at.material);
}

}  // namespace dapple::textbook
