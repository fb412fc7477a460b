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

Vec3f leave_surface(const SurfacePlace& place, const Vec3f& wi) {
  const Vec3f& n = place.normal;
  // The position is off by `error` at most, and adding rounds once more.
  const float step = 2.0f * place.error + kPositionError * max_abs_component(place.position);
  return place.position + (dot(wi, n) < 0 ? -step : step) * n;
}

SurfacePlace place_of(const Surface& surface) {
  const SurfaceInteraction& at = surface.at;
  return {at.position, at.geometric_normal, surface.error, surface.material, at.from_outside};
}

std::array<float, 4> PathVertices::numbers(const LightPath& path, Decision decision) const {
  return sampler_.uniform4(path.sample, dimension_of(path, decision));
}

void PathVertices::add(const Vec3f& radiance, LightPath& path) const {
  path.add(path.throughput * radiance, path.scatterings > 1, settings_.clamp_indirect);
}

bool PathVertices::advance(std::uint32_t index, LightPath& path, Ray& ray, const Hit& hit,
                           const Described& described, const VertexDraw& draw,
                           std::vector<ShadowRay>& shadow_rays, PendingVertices& pending) const {
  if (path.insides.innermost() != kVacuum) {
    const Medium medium = lit_.materials().interior(path.insides.innermost());
    if (medium.scatters()) {
      const auto u = numbers(path, Decision::medium);
      const auto event = sample_distance(medium, hit.t, path.throughput, u[0], u[1]);
      path.throughput = path.throughput * event.weight;
      if (event.scattered) {
        return scatter_in_medium(index, path, ray, event.distance, medium, draw, shadow_rays);
      }
    } else {
      path.throughput = path.throughput * transmittance(medium, hit.t);
    }
  }
  if (!hit.found()) {
    const EnvironmentLight& environment = lit_.lights().environment();
    escape(environment.radiance(ray.direction), environment.pdf(ray.direction), path);
    return false;
  }

  path.cone_width += path.cone_spread * hit.t;
  const SurfaceBuilder& surfaces = lit_.surfaces();
  const Surface surface =
      described.element
          ? surfaces.from_chunk(described.chunk, *described.element, ray, path.cone_width)
          : surfaces.build(scene_.accel(), ray, hit, path.cone_width);
  const auto& choose = draw.choose;
  const MaterialEvaluator& materials = lit_.materials();
  if (materials.may_be_transparent(surface.material) &&
      choose[0] >= materials.opacity(surface.material, surface.at)) {
    ray.origin = leave_surface(place_of(surface), ray.direction);
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

  if (materials.is_plain(surface.material)) {
    postpone(index, surface, ray, draw, path, pending);
    return true;
  }
  const Bsdf bsdf =
      materials.make_bsdf(surface.material, surface.at, -ray.direction, path.dispersion);
  ask_light(index, path, surface, bsdf, draw, shadow_rays);
  const auto sample = bsdf.sample(choose[1], {draw.move[0], draw.move[1]});
  return sample && scatter(place_of(surface), *sample, path, ray) && survives(choose[3], path);
}

void PathVertices::escape(const Vec3f& radiance, float environment_pdf, LightPath& path) const {
  if (!sees_environment(path)) return;
  float weight = 1;
  if (path.pdf > 0) {
    weight = power_heuristic(path.pdf, path.environment_share * environment_pdf);
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

std::optional<LightSample> PathVertices::sample_light(const Vec3f& position, const Vec3f& normal,
                                                      const VertexDraw& draw,
                                                      LightPath& path) const {
  const LightSet::Groups groups = lit_.lights().groups(position, normal);
  path.environment_share = groups.environment;
  return lit_.lights().sample(groups, position, normal, draw.choose[2],
                              {draw.move[2], draw.move[3]}, draw.environment);
}

void PathVertices::ask_light(std::uint32_t index, LightPath& path, const Surface& surface,
                             const Bsdf& bsdf, const VertexDraw& draw,
                             std::vector<ShadowRay>& shadow_rays) const {
  if (bsdf.is_specular_only()) return;
  const SurfaceInteraction& at = surface.at;
  const auto light = sample_light(at.position, at.geometric_normal, draw, path);
  if (!light || !(light->pdf > 0)) return;
  add_shadow_ray(index, path, place_of(surface), *light, bsdf.evaluate(light->wi), shadow_rays);
}

void PathVertices::add_shadow_ray(std::uint32_t index, const LightPath& path,
                                  const SurfacePlace& place, const LightSample& light,
                                  const BsdfValue& value,
                                  std::vector<ShadowRay>& shadow_rays) const {
  if (is_black(value.f)) return;
  const float weight = light.delta ? 1.0f : power_heuristic(light.pdf, value.pdf);
  const Vec3f contribution = (weight / light.pdf) * (path.throughput * value.f * light.radiance) *
                             through_medium(place, light.wi, light.distance, path);
  if (is_black(contribution)) return;
  ShadowRay shadow;
  shadow.ray = {leave_surface(place, light.wi), 0, light.wi, kBeforeLight * light.distance};
  shadow.contribution = contribution;
  shadow.path = index;
  shadow.indirect = path.scatterings > 0;
  shadow_rays.push_back(shadow);
}

// What is left of light that comes along wi, by the medium on that side of the surface.
Vec3f PathVertices::through_medium(const SurfacePlace& place, const Vec3f& wi, float distance,
                                   const LightPath& path) const {
  const bool transmitted = (dot(wi, place.normal) > 0) != place.from_outside;
  Insides insides = path.insides;
  if (transmitted) pass_through(place, wi, insides);
  if (insides.innermost() == kVacuum) return {1, 1, 1};
  return transmittance(lit_.materials().interior(insides.innermost()), distance);
}

bool PathVertices::scatter(const SurfacePlace& place, const BsdfSample& sample, LightPath& path,
                           Ray& ray) const {
  path.throughput = path.throughput * sample.weight;
  if (is_black(path.throughput)) return false;
  path.position = place.position;
  path.normal = place.normal;
  path.pdf = sample.specular ? 0.0f : sample.pdf;
  path.cone_spread = std::max(path.cone_spread, kConePerRoughness * sample.roughness);
  path.dispersion.alone |= sample.one_channel;
  if (sample.transmitted) pass_through(place, sample.wi, path.insides);
  ray.origin = leave_surface(place, sample.wi);
  ray.direction = sample.wi;
  path.passed = false;
  ++path.scatterings;
  ++path.vertices;
  return true;
}

void PathVertices::pass_through(const SurfacePlace& place, const Vec3f& wi,
                                Insides& insides) const {
  if (!lit_.materials().has_interior(place.material)) return;
  if (dot(wi, place.normal) < 0) {
    insides.enter(place.material);
  } else {
    insides.leave(place.material);
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
                                     const Medium& medium, const VertexDraw& draw,
                                     std::vector<ShadowRay>& shadow_rays) const {
  path.alpha = 1;
  path.cone_width += path.cone_spread * distance;
  if (path.scatterings >= settings_.max_scatterings) return false;
  const Vec3f position = ray.at(distance);
  const auto& choose = draw.choose;
  const auto& move = draw.move;
  const auto light = sample_light(position, {}, draw, path);
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
