#include "shading/scatter.h"

#include <cmath>

#include "math/warps.h"

namespace dapple {
namespace {

Vec3f reflect(const Vec3f& d, const Vec3f& n) { return d - 2.0f * dot(d, n) * n; }

std::optional<Scattered> scatter(const Lambertian& material, const Encounter& at,
                                 const std::array<float, 4>& u) {
  return Scattered{sample_cosine_hemisphere(at.normal, u[0], u[1]), Vec3f(material.albedo)};
}

std::optional<Scattered> scatter(const Metal& material, const Encounter& at,
                                 const std::array<float, 4>& u) {
  const auto fuzz = static_cast<float>(material.fuzz);
  Vec3f direction = reflect(at.direction, at.normal);
  // A perfect mirror's direction keeps its zeros' signs, so that nothing need be drawn for it.
  if (fuzz != 0.0f) direction = direction + fuzz * sample_uniform_ball(u[0], u[1], u[2]);
  if (!(dot(direction, at.normal) > 0.0f)) return std::nullopt;
  return Scattered{direction, Vec3f(material.albedo)};
}

std::optional<Scattered> scatter(const Dielectric& material, const Encounter& at,
                                 const std::array<float, 4>& u) {
  const auto ref_idx = static_cast<float>(material.ref_idx);
  const float eta = at.from_outside ? 1.0f / ref_idx : ref_idx;
  const float cos_exact = -dot(at.direction, at.normal);
  const float cos_in = cos_exact < 1.0f ? cos_exact : 1.0f;
  const float sin2_out = eta * eta * (1.0f - cos_in * cos_in);
  const Vec3f white(1, 1, 1);
  const Vec3f reflected = reflect(at.direction, at.normal);
  if (!(sin2_out <= 1.0f)) return Scattered{reflected, white};  // total internal reflection
  const float cos_out = std::sqrt(1.0f - sin2_out);
  const float cos_in_thinner = eta < 1.0f ? cos_in : cos_out;
  if (u[0] < schlick_reflectance(cos_in_thinner, ref_idx)) return Scattered{reflected, white};
  return Scattered{eta * at.direction + (eta * cos_in - cos_out) * at.normal, white};
}
// Belongs to another transport than this one.
std::optional<Scattered> scatter(const Layered&, const Encounter&, const std::array<float, 4>&) {
  return std::nullopt;
}

}  // namespace

float schlick_reflectance(float cosine, float ref_idx) {
  const float root = (1.0f - ref_idx) / (1.0f + ref_idx);
  const float at_normal = root * root;
  const float c = 1.0f - cosine;
  const float c2 = c * c;
  return at_normal + (1.0f - at_normal) * (c2 * c2 * c);
}

std::optional<Scattered> scatter(const Material& material, const Encounter& encounter,
                                 const std::array<float, 4>& u) {
  return std::visit([&](const auto& m) { return scatter(m, encounter, u); }, material);
}

}  // namespace dapple
