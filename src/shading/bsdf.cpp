#include "shading/bsdf.h"

#include "math/fast_functions.h"
#include "math/warps.h"
#include "shading/microfacet.h"

namespace dapple {
namespace {

constexpr float kMirrorAlpha = 1e-4f;  // below it the interface is a mirror

float fifth_power(float x) {
  const float x2 = x * x;
  return x2 * x2 * x;
}

Vec3f schlick(const Vec3f& f0, float f90, float cosine) {
  return f0 + fifth_power(1.0f - cosine) * (Vec3f(f90, f90, f90) - f0);
}

}  // namespace

BsdfValue Bsdf::evaluate(const Vec3f& wi_world) const {
  const Vec3f wi = frame_.to_local(wi_world);
  if (!(wi.z > 0.0f) || !(dot(wi_world, geometric_normal_) > 0.0f)) return {};
  BsdfValue result{diffuse_ * (wi.z * kInvPi), p_diffuse_ * wi.z * kInvPi};
  if (alpha_ < kMirrorAlpha) return result;
  const MicrofacetDistribution facets{alpha_, alpha_};
  const Vec3f h = normalize(wo_ + wi);
  const float cosine = dot(wi, h);
  const float d = facets.d(h);
  result.f = result.f + (d * facets.g2(wo_, wi) / (4.0f * wo_.z)) * schlick(f0_, f90_, cosine);
  result.pdf += (1.0f - p_diffuse_) * facets.g1(wo_) * d / (4.0f * wo_.z);
  return result;
}

std::optional<BsdfSample> Bsdf::sample(float u_lobe, Vec2f u) const {
  BsdfSample result;
  Vec3f wi;
  if (u_lobe < p_diffuse_) {
    wi = sample_cosine_hemisphere({0, 0, 1}, u.x, u.y);
  } else if (alpha_ < kMirrorAlpha) {
    result.wi = frame_.to_world({-wo_.x, -wo_.y, wo_.z});
    result.weight = schlick(f0_, f90_, wo_.z) / (1.0f - p_diffuse_);
    result.roughness = 0;
    result.specular = true;
    if (!(dot(result.wi, geometric_normal_) > 0.0f)) return std::nullopt;
    return result;
  } else {
    const Vec3f h = MicrofacetDistribution{alpha_, alpha_}.sample(wo_, u);
    wi = 2.0f * dot(wo_, h) * h - wo_;
    result.roughness = alpha_;
  }
  result.wi = frame_.to_world(wi);
  const BsdfValue value = evaluate(result.wi);
  if (!(value.pdf > 0.0f)) return std::nullopt;
  result.weight = value.f / value.pdf;
  result.pdf = value.pdf;
  return result;
}

}  // namespace dapple
