#include "shading/albedo_integrals.h"

#include <algorithm>
#include <cmath>

#include "math/warps.h"
#include "shading/albedo_tables.h"
#include "shading/fresnel.h"
#include "shading/microfacet.h"
#include "shading/refraction.h"
#include "shading/sheen.h"

namespace dapple {
namespace {

Vec3f view(float cosine) { return {std::sqrt((1.0f - cosine) * (1.0f + cosine)), 0.0f, cosine}; }

// The sum of f over the midpoints of a grid of cells of the unit square.
template <class Function>
auto sum_over_square(int grid, Function f) {
  decltype(f(Vec2f{})) sum{};
  for (int i = 0; i < grid; ++i) {
    for (int j = 0; j < grid; ++j) {
      const auto n = static_cast<float>(grid);
      sum = sum + f(Vec2f{(static_cast<float>(i) + 0.5f) / n, (static_cast<float>(j) + 0.5f) / n});
    }
  }
  return sum;
}

// Of facets that are seen from wo, the part that is seen from wi too.
double seen(const MicrofacetDistribution& facets, const Vec3f& wo, const Vec3f& wi) {
  const double near = 1.0 + facets.lambda(wo);
  return near / (near + facets.lambda(wi));
}

SplitAlbedo reflection(const MicrofacetDistribution& facets, const Vec3f& wo, int grid) {
  const Vec3d sum = sum_over_square(grid, [&](Vec2f u) {
    const Vec3f h = facets.sample(wo, u);
    const Vec3f wi = 2.0f * dot(wo, h) * h - wo;
    if (!(wi.z > 0.0f)) return Vec3d();
    const double whole = seen(facets, wo, wi);
    const double bias = whole * schlick_weight(dot(wo, h));
    return Vec3d(whole - bias, bias, 0);
  });
  const double n = static_cast<double>(grid) * grid;
  return {sum.x / n, sum.y / n};
}

}  // namespace

SplitAlbedo integrate_reflection(float cosine, float roughness, int grid) {
  const float alpha = roughness * roughness;
  if (alpha < MicrofacetDistribution::kMirrorAlpha) {
    return {1.0 - schlick_weight(cosine), schlick_weight(cosine)};
  }
  return reflection({alpha, alpha}, view(cosine), grid);
}

SplitAlbedo integrate_brushed(float cosine, float azimuth, float along, float across, int grid) {
  const MicrofacetDistribution facets{std::max(along * along, kLeastBrushedAlpha),
                                      std::max(across * across, kLeastBrushedAlpha)};
  const float sine = view(cosine).x;
  return reflection(facets,
                    {sine * azimuth, sine * std::sqrt((1.0f - azimuth) * (1.0f + azimuth)), cosine},
                    grid);
}

double integrate_refraction(float cosine, float roughness, float eta, int grid) {
  const float alpha = roughness * roughness;
  if (alpha < MicrofacetDistribution::kMirrorAlpha) return 1;
  const MicrofacetDistribution facets{alpha, alpha};
  const Vec3f wo = view(cosine);
  const double sum = sum_over_square(grid, [&](Vec2f u) {
    const Vec3f h = facets.sample(wo, u);
    const float c = dot(wo, h);
    const double reflected = fresnel_dielectric(c, eta);
    double result = 0;
    const Vec3f mirrored = 2.0f * c * h - wo;
    if (mirrored.z > 0.0f) result += reflected * seen(facets, wo, mirrored);
    Vec3f through;
    if (refract(wo, h, eta, through) && through.z < 0.0f) {
      result += (1 - reflected) * seen(facets, wo, through);
    }
    return result;
  });
  return sum / (static_cast<double>(grid) * grid);
}

double integrate_sheen(float cosine, float roughness, int grid) {
  const SheenDistribution sheen(roughness);
  const Vec3f wo = view(cosine);
  // Uniform in solid angle: cosine-weighted points are sparse where sheen is.
  const double sum = sum_over_square(grid, [&](Vec2f u) {
    const Vec3f wi = sample_uniform_sphere(0.5f * u.x, u.y);
    return double{sheen.evaluate(wo, wi)};
  });
  return 2 * double{kPi} * sum / (static_cast<double>(grid) * grid);
}

}  // namespace dapple
