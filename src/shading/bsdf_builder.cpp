#include "shading/bsdf_builder.h"

#include <algorithm>
#include <variant>

namespace dapple {
namespace {

float luminance(const Vec3f& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

// Moves the shading normal n to where the mirror direction of wo stays above the surface, by
// lifting that direction [KellerWRSG17].
Vec3f valid_shading_normal(const Vec3f& n, const Vec3f& geometric, const Vec3f& wo) {
  const Vec3f mirrored = 2.0f * dot(n, wo) * n - wo;
  const float lowest = std::min(0.9f * dot(geometric, wo), 0.01f);
  const float height = dot(geometric, mirrored);
  if (height >= lowest) return n;
  const Vec3f lifted = mirrored + (lowest - height) * geometric;
  return normalize(wo + normalize(lifted));
}

}  // namespace

BsdfBuilder::BsdfBuilder(const SurfaceInteraction& at, const Vec3f& wo) {
  const float side = at.from_outside ? 1.0f : -1.0f;
  bsdf_.geometric_normal_ = side * at.geometric_normal;
  const Vec3f n = valid_shading_normal(side * at.shading_normal, bsdf_.geometric_normal_, wo);
  bsdf_.frame_ = frame_along(n, at.tangent);
  bsdf_.wo_ = bsdf_.frame_.to_local(wo);
  bsdf_.wo_.z = std::max(bsdf_.wo_.z, 1e-4f);
}

void BsdfBuilder::metallic_roughness(const Vec3f& base_colour, float metallic, float roughness) {
  const Vec3f dielectric(0.04f, 0.04f, 0.04f);
  bsdf_.f0_ = dielectric + metallic * (base_colour - dielectric);
  bsdf_.diffuse_ = ((1.0f - metallic) * 0.95f) * base_colour;
  bsdf_.alpha_ = roughness * roughness;
}

void BsdfBuilder::classic(const Material& material) {
  if (const auto* diffuse = std::get_if<Lambertian>(&material)) {
    bsdf_.diffuse_ = Vec3f(diffuse->albedo);
    bsdf_.f90_ = 0;
  } else if (const auto* metal = std::get_if<Metal>(&material)) {
    bsdf_.f0_ = Vec3f(metal->albedo);
    bsdf_.alpha_ = std::min(1.0f, static_cast<float>(metal->fuzz));
  }
}

Bsdf BsdfBuilder::build() {
  const float specular = luminance(bsdf_.f0_) + 0.05f * bsdf_.f90_;
  const float diffuse = luminance(bsdf_.diffuse_);
  bsdf_.p_diffuse_ = diffuse + specular > 0.0f ? diffuse / (diffuse + specular) : 1.0f;
  bsdf_.albedo_ = bsdf_.diffuse_ + bsdf_.f0_;
  bsdf_.specular_only_ = diffuse <= 0.0f && bsdf_.alpha_ < 1e-4f;
  return bsdf_;
}

}  // namespace dapple
