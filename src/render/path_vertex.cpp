#include "render/path_vertex.h"

#include <algorithm>
#include <cmath>

#include "render/lit_scene.h"

namespace dapple {
namespace {

// Vertices that a path may pass straight through, beyond those where it scatters.
constexpr int kMaxPassages = 64;
// From here on a path goes on with the probability that its throughput says.
constexpr int kFirstRoulette = 3;
// A shadow ray ends just before the light that it goes to.
constexpr float kBeforeLight = 1 - 1e-4f;
// How much of a lobe's roughness widens the cone of what it scatters.
constexpr float kConePerRoughness = 0.25f;

float power_heuristic(float taken, float other) {
  const float a = taken * taken, b = other * other;
  return a + b > 0 ? a / (a + b) : 0.0f;
}

bool is_black(const Vec3f& c) { return !(c.x > 0 || c.y > 0 || c.z > 0); }

}  // namespace

Vec3f leave_surface(const Surface& surface, const Vec3f& wi) {
  const Vec3f& n = surface.at.geometric_normal;
  // The position is off by `error` at most, and adding rounds once more.
  const float step = 2.0f * surface.error + kPositionError * max_abs_component(surface.at.position);
  return surface.at.position + (dot(wi, n) < 0 ? -step : step) * n;
}

std::array<float, 4> PathVertices::numbers(const LightPath& path, Decision decision) const {
  const auto dimension = path.vertices * static_cast<std::uint32_t>(Decision::count) +
                         static_cast<std::uint32_t>(decision);
  return sampler_.uniform4(path.sample, dimension);
}

void PathVertices::add(const Vec3f& radiance, LightPath& path) const {
  path.add(path.throughput * radiance, path.scatterings > 1, settings_.clamp_indirect);
}

bool PathVertices::advance(std::uint32_t index, LightPath& path, Ray& ray, const Hit& hit,
                           std::vector<ShadowRay>& shadow_rays) const {
  if (path.insides.innermost() != kVacuum) {
    const Medium medium = lit_.materials().interior(path.insides.innermost());
    if (medium.scatters()) {
      const auto u = numbers(path, Decision::medium);
      const auto event = sample_distance(medium, hit.t, path.throughput, u[0], u[1]);
      path.throughput = path.throughput * event.weight;
      if (event.scattered) {
        return scatter_in_medium(index, path, ray, event.distance, medium, shadow_rays);
      }
    } else {
      path.throughput = path.throughput * transmittance(medium, hit.t);
    }
  }
  if (!hit.found()) {
    see_environment(ray, path);
    return false;
  }

  path.cone_width += path.cone_spread * hit.t;
  const Surface surface = lit_.surfaces().build(scene_.accel(), ray, hit, path.cone_width);
  const auto choose = numbers(path, Decision::choose);
  const MaterialEvaluator& materials = lit_.materials();
  if (materials.may_be_transparent(surface.material) &&
      choose[0] >= materials.opacity(surface.material, surface.at)) {
    ray.origin = leave_surface(surface, ray.direction);
    path.passed = true;
    return ++path.vertices < path.scatterings + kMaxPassages;
  }
  path.alpha = 1;
  if (materials.is_unlit(surface.material)) {
    add(materials.unlit_colour(surface.material, surface.at), path);
    return false;
  }
  see_emission(surface, ray, hit.t, path);
  if (path.scatterings >= settings_.max_scatterings) return false;

  const Bsdf bsdf =
      materials.make_bsdf(surface.material, surface.at, -ray.direction, path.dispersion);
  const auto move = numbers(path, Decision::move);
  ask_light(index, path, surface, bsdf, choose[2], {move[2], move[3]}, shadow_rays);
  return scatter(surface, bsdf, choose[1], {move[0], move[1]}, path, ray) &&
         survives(choose[3], path);
}

void PathVertices::see_environment(const Ray& ray, LightPath& path) const {
  if (path.alpha == 0 && settings_.transparent_background) return;
  const Vec3f radiance = lit_.lights().environment().radiance(ray.direction);
  float weight = 1;
  if (path.pdf > 0) {
    const float other = lit_.lights().pdf_of_environment(path.position, path.normal, ray.direction);
    weight = power_heuristic(path.pdf, other);
  }
  path.alpha = 1;
  add(weight * radiance, path);
}

void PathVertices::see_emission(const Surface& surface, const Ray& ray, float distance,
                                LightPath& path) const {
  if (!lit_.materials().is_emissive(surface.material)) return;
  const Vec3f radiance = lit_.materials().emission(surface.material, surface.at);
  if (is_black(radiance)) return;
  float weight = 1;
  if (path.pdf > 0) {
    // Passages through transparent surfaces lie between, so the distance is not the ray's own.
    const Vec3f from = surface.at.position - path.position;
    const float whole = path.passed ? length(from) : distance;
    const float other = lit_.lights().pdf_of_hit(surface.emitter, path.position, path.normal,
                                                 ray.direction, whole, surface.at.geometric_normal);
    weight = power_heuristic(path.pdf, other);
  }
  add(weight * radiance, path);
}

void PathVertices::ask_light(std::uint32_t index, const LightPath& path, const Surface& surface,
                             const Bsdf& bsdf, float u_choose, Vec2f u,
                             std::vector<ShadowRay>& shadow_rays) const {
  if (bsdf.is_specular_only()) return;
  const SurfaceInteraction& at = surface.at;
  const auto light = lit_.lights().sample(at.position, at.geometric_normal, u_choose, u);
  if (!light || !(light->pdf > 0)) return;
  const BsdfValue value = bsdf.evaluate(light->wi);
  if (is_black(value.f)) return;
  const float weight = light->delta ? 1.0f : power_heuristic(light->pdf, value.pdf);
  const Vec3f contribution = (weight / light->pdf) * (path.throughput * value.f * light->radiance) *
                             through_medium(surface, light->wi, light->distance, path);
  if (is_black(contribution)) return;
  ShadowRay shadow;
  shadow.ray = {leave_surface(surface, light->wi), 0, light->wi, kBeforeLight * light->distance};
  shadow.contribution = contribution;
  shadow.path = index;
  shadow.indirect = path.scatterings > 0;
  shadow_rays.push_back(shadow);
}

// What is left of light that comes along wi, by the medium on that side of the surface.
Vec3f PathVertices::through_medium(const Surface& surface, const Vec3f& wi, float distance,
                                   const LightPath& path) const {
  const Vec3f& outward = surface.at.geometric_normal;
  const bool transmitted = (dot(wi, outward) > 0) != surface.at.from_outside;
  Insides insides = path.insides;
  if (transmitted) pass_through(surface, wi, insides);
  if (insides.innermost() == kVacuum) return {1, 1, 1};
  return transmittance(lit_.materials().interior(insides.innermost()), distance);
}

bool PathVertices::scatter(const Surface& surface, const Bsdf& bsdf, float u_lobe, Vec2f u,
                           LightPath& path, Ray& ray) const {
  const auto sample = bsdf.sample(u_lobe, u);
  if (!sample) return false;
  path.throughput = path.throughput * sample->weight;
  if (is_black(path.throughput)) return false;
  path.position = surface.at.position;
  path.normal = surface.at.geometric_normal;
  path.pdf = sample->specular ? 0.0f : sample->pdf;
  path.cone_spread = std::max(path.cone_spread, kConePerRoughness * sample->roughness);
  path.dispersion.alone |= sample->one_channel;
  if (sample->transmitted) pass_through(surface, sample->wi, path.insides);
  ray.origin = leave_surface(surface, sample->wi);
  ray.direction = sample->wi;
  path.passed = false;
  ++path.scatterings;
  ++path.vertices;
  return true;
}

void PathVertices::pass_through(const Surface& surface, const Vec3f& wi, Insides& insides) const {
  if (!lit_.materials().has_interior(surface.material)) return;
  if (dot(wi, surface.at.geometric_normal) < 0) {
    insides.enter(surface.material);
  } else {
    insides.leave(surface.material);
  }
}

// With the probability that the throughput says, at least a little, so that dark paths end soon.
bool PathVertices::survives(float u, LightPath& path) const {
  if (path.scatterings < kFirstRoulette) return true;
  const Vec3f& t = path.throughput;
  const float probability = std::min(1.0f, std::max({t.x, t.y, t.z}));
  if (!(u < probability)) return false;
  path.throughput = path.throughput / probability;
  return true;
}

bool PathVertices::scatter_in_medium(std::uint32_t index, LightPath& path, Ray& ray, float distance,
                                     const Medium& medium,
                                     std::vector<ShadowRay>& shadow_rays) const {
  path.alpha = 1;
  path.cone_width += path.cone_spread * distance;
  if (path.scatterings >= settings_.max_scatterings) return false;
  const Vec3f position = ray.at(distance);
  const auto choose = numbers(path, Decision::choose);
  const auto move = numbers(path, Decision::move);
  const auto light = lit_.lights().sample(position, {}, choose[2], {move[2], move[3]});
  if (light && light->pdf > 0) {
    const float density = phase(dot(ray.direction, light->wi), medium.g);
    const float weight = light->delta ? 1.0f : power_heuristic(light->pdf, density);
    const Vec3f contribution =
        (weight * density / light->pdf) *
        (path.throughput * light->radiance * transmittance(medium, light->distance));
    if (!is_black(contribution)) {
      shadow_rays.push_back({{position, 0, light->wi, kBeforeLight * light->distance},
                             contribution,
                             index,
                             path.scatterings > 0});
    }
  }
  const Vec3f next = sample_phase(ray.direction, medium.g, {move[0], move[1]});
  path.pdf = phase(dot(ray.direction, next), medium.g);
  path.position = position;
  path.normal = {};
  path.passed = false;
  ray.origin = position;
  ray.direction = next;
  ++path.scatterings;
  ++path.vertices;
  return survives(choose[3], path);
}

}  // namespace dapple
