#include "shading/bsdf.h"

#include <algorithm>

#include "math/fast_functions.h"
#include "math/warps.h"
#include "shading/colour.h"
#include "shading/fresnel.h"
#include "shading/microfacet.h"
#include "shading/refraction.h"
#include "shading/sheen.h"

namespace dapple {
namespace {

constexpr float kCoatF0 = 0.04f;  // index of refraction 1.5

Vec3f below(const Vec3f& w) { return {w.x, w.y, -w.z}; }

}  // namespace

Bsdf::Facet Bsdf::glass_facet(float cosine) const {
  const float exact = fresnel_dielectric(cosine, eta_);
  if (exact >= 1.0f) return {grey(glass_), {}, 1};
  // Specular colour and strength bend Fresnel's curve between their own ends.
  const float ior_f0 = f0_of_ior(eta_);
  const Vec3f reflected = mix(glass_f0_, grey(glass_f90_), (exact - ior_f0) / (1.0f - ior_f0));
  return {glass_ * reflected, (glass_ * (1.0f - max_component(reflected))) * glass_tint_, 1};
}

Bsdf::Facet Bsdf::facet(float cosine) const {
  Facet result{f0_ + schlick_weight(cosine) * f90_minus_f0_, straight_, 1};
  if (glass_ > 0.0f) {
    const Facet glass = glass_facet(cosine);
    result.reflected = result.reflected + glass.reflected;
    result.transmitted = glass.transmitted;
  }
  const float r = luminance(result.reflected), t = luminance(result.transmitted);
  if (t > 0.0f) result.p_reflect = r / (r + t);
  return result;
}

BsdfValue Bsdf::evaluate(const Vec3f& wi_world) const {
  const Vec3f wi = frame_.to_local(wi_world);
  const bool above = dot(wi_world, geometric_normal_) > 0.0f;
  // What the two normals put on different sides would leak or shine through.
  if (above) return evaluate_reflection(wi);
  return wi.z < 0.0f ? evaluate_transmission(wi) : BsdfValue{};
}

BsdfValue Bsdf::evaluate_reflection(const Vec3f& wi) const {
  BsdfValue value;
  if (coat_ > 0.0f && !coat_mirror_) add_coat(wi, value);
  if (!(wi.z > 0.0f)) return value;
  if (p_diffuse_ > 0.0f) {
    value.f = value.f + (wi.z * kInvPi) * diffuse_;
    value.pdf += p_diffuse_ * wi.z * kInvPi;
    if (sheen_roughness_ > 0.0f) {
      value.f = value.f + SheenDistribution(sheen_roughness_).evaluate(wo_, wi) * sheen_;
    }
  }
  if (p_interface_ > 0.0f && !mirror_) add_interface_reflection(wi, value);
  return value;
}

BsdfValue Bsdf::evaluate_transmission(const Vec3f& wi) const {
  BsdfValue value;
  if (p_through_ > 0.0f) {
    value = {(-wi.z * kInvPi) * through_, p_through_ * -wi.z * kInvPi};
  }
  if (p_interface_ > 0.0f && !mirror_) {
    if (glass_ > 0.0f) {
      add_refraction(wi, value);
    } else if (max_component(straight_) > 0.0f) {
      add_straight_through(wi, value);
    }
  }
  return value;
}

void Bsdf::add_coat(const Vec3f& wi, BsdfValue& value) const {
  const float cos_i = dot(wi, coat_normal_), cos_o = dot(wo_, coat_normal_);
  if (!(cos_i > 0.0f) || !(cos_o > 0.0f)) return;
  const Vec3f h = normalize(wo_ + wi);
  const Vec3f sine = cross(h, coat_normal_);
  const IsotropicMicrofacets facets(coat_alpha_);
  const float common = facets.d(dot(sine, sine)) / (4.0f * cos_o);
  const float lambda_o = facets.lambda(cos_o);
  const float fresnel = kCoatF0 + (1.0f - kCoatF0) * schlick_weight(dot(wi, h));
  value.f = value.f + grey(coat_ * fresnel * common / (1.0f + lambda_o + facets.lambda(cos_i)));
  value.pdf += p_coat_ * common / (1.0f + lambda_o);
}

void Bsdf::add_interface_reflection(const Vec3f& wi, BsdfValue& value) const {
  const MicrofacetDistribution facets{alpha_x_, alpha_y_};
  const Vec3f h = normalize(wo_ + wi);
  const Facet at = facet(dot(wi, h));
  const float common = facets.d(h) / (4.0f * wo_.z);
  const float lambda_o = facets.lambda(wo_);
  value.f = value.f + (common / (1.0f + lambda_o + facets.lambda(wi))) * at.reflected;
  value.pdf += p_interface_ * at.p_reflect * common / (1.0f + lambda_o);
}

void Bsdf::add_refraction(const Vec3f& wi, BsdfValue& value) const {
  Vec3f h = normalize(wo_ + eta_ * wi);
  if (h.z < 0.0f) h = -h;
  const float cos_o = dot(wo_, h), cos_i = dot(wi, h);
  if (!(cos_o > 0.0f) || !(cos_i < 0.0f)) return;
  const MicrofacetDistribution facets{alpha_x_, alpha_y_};
  const Facet at = facet(cos_o);
  const float root = cos_o + eta_ * cos_i;
  // Visible normals, times the solid angle of normals over that of directions.
  const float common =
      facets.d(h) * cos_o / wo_.z * (eta_ * eta_ * -cos_i) / std::max(root * root, 1e-18f);
  const float lambda_o = facets.lambda(wo_);
  value.f = value.f + (common / (1.0f + lambda_o + facets.lambda(wi))) * at.transmitted;
  value.pdf += p_interface_ * (1.0f - at.p_reflect) * common / (1.0f + lambda_o);
}

void Bsdf::add_straight_through(const Vec3f& wi, BsdfValue& value) const {
  const MicrofacetDistribution facets{alpha_x_, alpha_y_};
  const Vec3f mirrored = below(wi);
  const Vec3f h = normalize(wo_ + mirrored);
  const Facet at = facet(dot(mirrored, h));
  const float common = facets.d(h) / (4.0f * wo_.z);
  const float lambda_o = facets.lambda(wo_);
  value.f = value.f + (common / (1.0f + lambda_o + facets.lambda(mirrored))) * at.transmitted;
  value.pdf += p_interface_ * (1.0f - at.p_reflect) * common / (1.0f + lambda_o);
}

std::optional<BsdfSample> Bsdf::sample(float u_lobe, Vec2f u) const {
  if (u_lobe < p_interface_) return sample_interface(u_lobe / p_interface_, u);
  u_lobe -= p_interface_;
  if (u_lobe < p_diffuse_) return finish(sample_cosine_hemisphere({0, 0, 1}, u.x, u.y), 1, false);
  u_lobe -= p_diffuse_;
  if (u_lobe < p_coat_) return sample_coat(u);
  if (!(p_through_ > 0.0f)) return std::nullopt;
  return finish(below(sample_cosine_hemisphere({0, 0, 1}, u.x, u.y)), 1, true);
}

std::optional<BsdfSample> Bsdf::sample_coat(Vec2f u) const {
  if (coat_mirror_) {
    const Vec3f wi = reflect_about(wo_, coat_normal_);
    const float fresnel = kCoatF0 + (1.0f - kCoatF0) * schlick_weight(dot(wo_, coat_normal_));
    return finish_specular(wi, grey(coat_ * fresnel / p_coat_), false);
  }
  const Frame frame = frame_around(coat_normal_);
  const MicrofacetDistribution facets{coat_alpha_, coat_alpha_};
  const Vec3f h = frame.to_world(facets.sample(frame.to_local(wo_), u));
  const Vec3f wi = reflect_about(wo_, h);
  if (!(dot(wi, coat_normal_) > 0.0f)) return std::nullopt;
  return finish(wi, std::sqrt(coat_alpha_), false);
}

std::optional<BsdfSample> Bsdf::sample_interface(float u_choice, Vec2f u) const {
  const MicrofacetDistribution facets{alpha_x_, alpha_y_};
  const Vec3f h = mirror_ ? Vec3f(0, 0, 1) : facets.sample(wo_, u);
  const Facet at = facet(dot(wo_, h));
  const bool reflects = u_choice < at.p_reflect;
  Vec3f wi = reflect_about(wo_, h);
  if (!reflects && glass_ > 0.0f) {
    if (!refract(wo_, h, eta_, wi)) return std::nullopt;
  } else if (!reflects) {
    wi = below(wi);
  }
  // Behind another facet; a single scattering does not get out there.
  if ((wi.z > 0.0f) != reflects) return std::nullopt;
  if (!mirror_) return finish(wi, std::sqrt(std::max(alpha_x_, alpha_y_)), !reflects);
  const float p = p_interface_ * (reflects ? at.p_reflect : 1.0f - at.p_reflect);
  return finish_specular(wi, (reflects ? at.reflected : at.transmitted) / p, !reflects);
}

std::optional<BsdfSample> Bsdf::finish(const Vec3f& local_wi, float roughness,
                                       bool transmitted) const {
  BsdfSample result;
  result.wi = frame_.to_world(local_wi);
  // On the wrong side of the geometric surface.
  if ((dot(result.wi, geometric_normal_) > 0.0f) == transmitted) return std::nullopt;
  const BsdfValue value =
      transmitted ? evaluate_transmission(local_wi) : evaluate_reflection(local_wi);
  if (!(value.pdf > 0.0f)) return std::nullopt;
  result.weight = value.f / value.pdf;
  result.pdf = value.pdf;
  result.roughness = roughness;
  result.transmitted = transmitted;
  result.one_channel = transmitted && one_channel_;
  return result;
}

std::optional<BsdfSample> Bsdf::finish_specular(const Vec3f& local_wi, const Vec3f& weight,
                                                bool transmitted) const {
  BsdfSample result;
  result.wi = frame_.to_world(local_wi);
  if ((dot(result.wi, geometric_normal_) > 0.0f) == transmitted) return std::nullopt;
  result.weight = weight;
  result.roughness = 0;
  result.specular = true;
  result.transmitted = transmitted;
  result.one_channel = transmitted && one_channel_;
  return result;
}

}  // namespace dapple
