#include "shading/bsdf_builder.h"

#include <algorithm>
#include <variant>

#include "shading/albedo_tables.h"
#include "shading/colour.h"
#include "shading/fresnel.h"
#include "shading/microfacet.h"
#include "shading/thin_film.h"

namespace dapple {
namespace {

constexpr float kLeastCosine = 1e-4f;
constexpr float kLeastIor = 1.001f;  // nearer to 1 the facets of a refraction cannot be told

// Moves the shading normal n to where the mirror direction of wo stays above the surface, by
// lifting that direction [KellerWRSG17]. Without this, normal maps and smooth silhouettes would
// turn black, or show what lies behind the surface.
Vec3f valid_shading_normal(const Vec3f& n, const Vec3f& geometric, const Vec3f& wo) {
  const Vec3f mirrored = 2.0f * dot(n, wo) * n - wo;
  const float lowest = std::min(0.9f * dot(geometric, wo), 0.01f);
  const float height = dot(geometric, mirrored);
  if (height >= lowest) return n;
  const Vec3f half = wo + normalize(mirrored + (lowest - height) * geometric);
  const float squared = dot(half, half);
  return squared > 1e-8f ? half / std::sqrt(squared) : geometric;
}

// What scattering between facets adds to a single one, as a factor for a mirror of reflectance
// f0 [Turquin19].
Vec3f multiple_scattering(const Vec3f& f0, float total) {
  return grey(1.0f) + (1.0f / total - 1.0f) * f0;
}

Vec3f with_film(const Vec3f& f0, const LayeredPoint& point, float cosine) {
  if (!(point.iridescence > 0.0f)) return f0;
  const Vec3f film = thin_film_reflectance(cosine, point.iridescence_ior, point.iridescence_nm, f0);
  // The value at normal incidence from which Schlick's curve passes through the film's.
  const float w = std::min(schlick_weight(cosine), 0.9999f);
  const auto at_normal = [&](float r) { return std::clamp((r - w) / (1.0f - w), 0.0f, 1.0f); };
  return mix(f0, Vec3f(at_normal(film.x), at_normal(film.y), at_normal(film.z)), point.iridescence);
}

float channel_ior(const LayeredPoint& point, DispersionChannel dispersion) {
  const float ior = std::max(point.ior, kLeastIor);
  const float half_spread = (ior - 1.0f) * 0.025f * point.dispersion;
  return std::max(ior + static_cast<float>(dispersion.channel - 1) * half_spread, kLeastIor);
}

}  // namespace

BsdfBuilder::BsdfBuilder(const SurfaceInteraction& at, const Vec3f& wo)
    : at_(at), world_wo_(wo), side_(at.from_outside ? 1.0f : -1.0f) {
  bsdf_.geometric_normal_ = side_ * at.geometric_normal;
}

void BsdfBuilder::set_frame(const Vec3f& normal, const Vec3f& tangent) {
  const Vec3f n = valid_shading_normal(side_ * normal, bsdf_.geometric_normal_, world_wo_);
  bsdf_.frame_ = frame_along(n, tangent);
  bsdf_.wo_ = bsdf_.frame_.to_local(world_wo_);
  bsdf_.wo_.z = std::max(bsdf_.wo_.z, kLeastCosine);
}

void BsdfBuilder::set_width(float alpha_x, float alpha_y) {
  bsdf_.alpha_x_ = alpha_x;
  bsdf_.alpha_y_ = alpha_y;
  bsdf_.mirror_ = alpha_x < MicrofacetDistribution::kMirrorAlpha;
}

// Returns what reaches the layers below.
float BsdfBuilder::add_coat(const LayeredPoint& point) {
  const Vec3f normal =
      valid_shading_normal(side_ * point.clearcoat_normal, bsdf_.geometric_normal_, world_wo_);
  bsdf_.coat_normal_ = bsdf_.frame_.to_local(normal);
  bsdf_.coat_alpha_ = point.clearcoat_roughness * point.clearcoat_roughness;
  bsdf_.coat_mirror_ = bsdf_.coat_alpha_ < MicrofacetDistribution::kMirrorAlpha;
  const float f0 = f0_of_ior(1.5f);
  const ReflectionAlbedo albedo =
      reflection_albedo(dot(bsdf_.wo_, bsdf_.coat_normal_), point.clearcoat_roughness);
  bsdf_.coat_ = point.clearcoat * multiple_scattering(grey(f0), albedo.total()).x;
  coat_albedo_ = bsdf_.coat_ * (f0 * albedo.scale + albedo.bias);
  return 1.0f - coat_albedo_;
}

// The same. Where the model would give more light than it gets, it gives all.
float BsdfBuilder::add_sheen(const LayeredPoint& point) {
  const float albedo = sheen_albedo(bsdf_.wo_.z, point.sheen_roughness);
  bsdf_.sheen_ = (1.0f / std::max(albedo, 1.0f)) * point.sheen_colour;
  bsdf_.sheen_roughness_ = std::max(point.sheen_roughness, 1e-3f);
  sheen_albedo_ = albedo;
  return 1.0f - albedo * max_component(bsdf_.sheen_);
}

void BsdfBuilder::add_reflection(const Vec3f& f0, const Vec3f& f90, float weight) {
  bsdf_.f0_ = bsdf_.f0_ + weight * f0;
  bsdf_.f90_minus_f0_ = bsdf_.f90_minus_f0_ + weight * (f90 - f0);
}

BsdfBuilder::Interface BsdfBuilder::add_interface(const LayeredPoint& point, float below_layers) {
  const float cosine = bsdf_.wo_.z;
  facets_ = bsdf_.alpha_x_ == bsdf_.alpha_y_
                ? reflection_albedo(cosine, roughness_)
                : brushed_albedo(bsdf_.wo_, bsdf_.alpha_x_, bsdf_.alpha_y_);
  Interface result{facets_.total(), {}, 1};
  if (point.metallic > 0.0f) {
    const Vec3f f0 = with_film(point.base_colour, point, cosine);
    const Vec3f factor = multiple_scattering(f0, result.total);
    add_reflection(factor * f0, factor, below_layers * point.metallic);
  }
  if (point.metallic < 1.0f) {
    const Vec3f f0 = with_film(point.dielectric_f0, point, cosine);
    const Vec3f f90 = grey(point.dielectric_f90);
    const Vec3f factor = multiple_scattering(f0, result.total);
    const float opaque = point.thin ? 1.0f : 1.0f - point.transmission;
    add_reflection(factor * f0, factor * f90, below_layers * (1.0f - point.metallic) * opaque);
    result.dielectric = factor * (facets_.scale * f0 + facets_.bias * f90);
    result.attenuation = std::max(1.0f - max_component(result.dielectric), 0.0f);
  }
  return result;
}

void BsdfBuilder::add_glass(const LayeredPoint& point, DispersionChannel dispersion, float weight) {
  const float ior = channel_ior(point, dispersion);
  bsdf_.eta_ = at_.from_outside ? ior : 1.0f / ior;
  glass_albedo_ = refraction_albedo(bsdf_.wo_.z, roughness_, bsdf_.eta_);
  bsdf_.glass_ = weight / glass_albedo_;
  bsdf_.glass_f0_ = with_film(point.dielectric_f0, point, bsdf_.wo_.z);
  bsdf_.glass_f90_ = point.dielectric_f90;
  bsdf_.glass_tint_ = point.base_colour;
  if (!(point.dispersion > 0.0f) || dispersion.alone) return;
  Vec3f channel;
  channel[dispersion.channel] = 3.0f;
  bsdf_.glass_tint_ = bsdf_.glass_tint_ * channel;
  bsdf_.one_channel_ = true;
}

Bsdf BsdfBuilder::layered(const LayeredPoint& point, DispersionChannel dispersion) {
  // The interface's shape.
  const Vec3f bitangent = at_.bitangent_sign * cross(point.normal, at_.tangent);
  set_frame(point.normal,
            point.anisotropy_direction.x * at_.tangent + point.anisotropy_direction.y * bitangent);
  const float alpha = point.roughness * point.roughness;
  set_width(alpha, alpha);
  roughness_ = point.roughness;
  if (point.anisotropy > 0.0f) {
    const float along = mix(alpha, 1.0f, point.anisotropy * point.anisotropy);
    set_width(along, std::max(alpha, 1e-3f));
    // Refraction has no table for uneven widths; their quadratic mean comes nearest.
    roughness_ = std::sqrt(
        std::sqrt(0.5f * (bsdf_.alpha_x_ * bsdf_.alpha_x_ + bsdf_.alpha_y_ * bsdf_.alpha_y_)));
  }

  // What lies on top is on the outer side of a solid.
  const bool has_top = at_.from_outside || point.thin;
  float reaches = 1;
  if (has_top && point.clearcoat > 0.0f) reaches *= add_coat(point);
  if (has_top && max_component(point.sheen_colour) > 0.0f) {
    const float below = add_sheen(point);
    bsdf_.sheen_ = reaches * bsdf_.sheen_;
    reaches *= below;
  }

  const Interface interface = add_interface(point, reaches);
  const float dielectric = reaches * (1.0f - point.metallic);
  const float transmitted = dielectric * point.transmission;
  if (transmitted > 0.0f && point.thin) {
    bsdf_.straight_ = (transmitted * interface.attenuation / interface.total) * point.base_colour;
  } else if (transmitted > 0.0f) {
    add_glass(point, dispersion, transmitted);
  }
  const float diffuse = (dielectric - transmitted) * interface.attenuation;
  bsdf_.diffuse_ = (diffuse * (1.0f - point.diffuse_transmission)) * point.base_colour;
  bsdf_.through_ = (diffuse * point.diffuse_transmission) * point.diffuse_transmission_colour;
  return finish();
}

Bsdf BsdfBuilder::classic(const Material& material) {
  set_frame(at_.shading_normal, at_.tangent);
  if (const auto* lambertian = std::get_if<Lambertian>(&material)) {
    bsdf_.diffuse_ = Vec3f(lambertian->albedo);
  } else if (const auto* metal = std::get_if<Metal>(&material)) {
    // About the spread that a ball of radius `fuzz` around the mirror direction has.
    const float alpha = std::clamp(0.5f * static_cast<float>(metal->fuzz), 0.0f, 1.0f);
    set_width(alpha, alpha);
    roughness_ = std::sqrt(alpha);
    const Vec3f albedo(metal->albedo);
    facets_ = reflection_albedo(bsdf_.wo_.z, roughness_);
    const Vec3f f0 = multiple_scattering(albedo, facets_.total()) * albedo;
    add_reflection(f0, f0, 1);
  } else if (const auto* glass = std::get_if<Dielectric>(&material)) {
    set_width(0, 0);
    const float ior = std::max(std::fabs(static_cast<float>(glass->ref_idx)), 1e-3f);
    bsdf_.eta_ = at_.from_outside ? ior : 1.0f / ior;
    bsdf_.glass_ = 1;
    bsdf_.glass_f0_ = grey(f0_of_ior(ior));
    bsdf_.glass_tint_ = grey(1);
  }
  return finish();
}

Bsdf BsdfBuilder::finish() {
  const Vec3f reflection =
      facets_.total() * (bsdf_.f0_ + bsdf_.straight_) + facets_.bias * bsdf_.f90_minus_f0_;
  Vec3f glass;
  if (bsdf_.glass_ > 0.0f) {
    const Bsdf::Facet at = bsdf_.glass_facet(bsdf_.wo_.z);
    glass = glass_albedo_ * (at.reflected + at.transmitted);
  }
  const Vec3f sheen = sheen_albedo_ * bsdf_.sheen_;
  bsdf_.albedo_ = reflection + glass + bsdf_.diffuse_ + sheen + bsdf_.through_ + grey(coat_albedo_);

  const float interface = luminance(reflection + glass);
  const float diffuse = luminance(bsdf_.diffuse_ + sheen);
  const float through = luminance(bsdf_.through_);
  const float total = interface + diffuse + through + coat_albedo_;
  if (total > 0.0f) {
    bsdf_.p_interface_ = interface / total;
    bsdf_.p_diffuse_ = diffuse / total;
    bsdf_.p_through_ = through / total;
    bsdf_.p_coat_ = coat_albedo_ / total;
  }
  bsdf_.specular_only_ = diffuse + through <= 0.0f && (bsdf_.mirror_ || interface <= 0.0f) &&
                         (bsdf_.coat_mirror_ || coat_albedo_ <= 0.0f);
  return bsdf_;
}

}  // namespace dapple
