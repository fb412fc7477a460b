// What happens to a path where its ray ends.
#pragma once

#include <vector>

#include "render/light_path.h"
#include "render/path_sampler.h"
#include "render/prepared_scene.h"
#include "render/settings.h"

namespace dapple {

// Decisions of one vertex, each with four random numbers of its own.
enum class Decision : std::uint32_t {
  camera,  // only of the first vertex: place in the pixel and on the lens
  choose,  // opacity, lobe, light, Russian roulette
  move,    // direction of the next ray, place on the light
  medium,  // channel, distance, direction
  count,
};

class PathVertices {
 public:
  PathVertices(const PreparedScene& scene, const PathSampler& sampler,
               const RenderSettings& settings)
      : scene_(scene), lit_(scene.lit()), sampler_(sampler), settings_(settings) {}

  // Deals with the end of `ray`, which `hit` says, and makes the next ray. Light that may come
  // straight from a light source is put on `shadow_rays` for path number `index`. False when the
  // path ends here.
  bool advance(std::uint32_t index, LightPath& path, Ray& ray, const Hit& hit,
               std::vector<ShadowRay>& shadow_rays) const;

  std::array<float, 4> numbers(const LightPath& path, Decision decision) const;

 private:
  bool scatter_in_medium(std::uint32_t index, LightPath& path, Ray& ray, float distance,
                         const Medium& medium, std::vector<ShadowRay>& shadow_rays) const;
  void add(const Vec3f& radiance, LightPath& path) const;
  void see_environment(const Ray& ray, LightPath& path) const;
  void see_emission(const Surface& surface, const Ray& ray, float distance, LightPath& path) const;
  void ask_light(std::uint32_t index, const LightPath& path, const Surface& surface,
                 const Bsdf& bsdf, float u_choose, Vec2f u,
                 std::vector<ShadowRay>& shadow_rays) const;
  bool scatter(const Surface& surface, const Bsdf& bsdf, float u_lobe, Vec2f u, LightPath& path,
               Ray& ray) const;
  Vec3f through_medium(const Surface& surface, const Vec3f& wi, float distance,
                       const LightPath& path) const;
  // To the side of the surface that wi points to.
  void pass_through(const Surface& surface, const Vec3f& wi, Insides& insides) const;
  bool survives(float u, LightPath& path) const;

  const PreparedScene& scene_;
  const LitScene& lit_;
  const PathSampler& sampler_;
  const RenderSettings& settings_;
};

// The point from which a ray in direction `wi` leaves the surface without meeting it again.
[[nodiscard]] Vec3f leave_surface(const Surface& surface, const Vec3f& wi);

}  // namespace dapple
