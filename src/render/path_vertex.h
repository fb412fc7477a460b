// What happens to a path where its ray ends.
#pragma once

#include <optional>
#include <vector>

#include "render/light_path.h"
#include "render/path_sampler.h"
#include "render/prepared_scene.h"
#include "render/settings.h"
#include "render/surface_builder.h"
#include "shading/bsdf_chunk.h"
#include "shading/light_set.h"

namespace dapple {

// Decisions of one vertex, each with four random numbers of its own.
enum class Decision : std::uint32_t {
  camera,  // only of the first vertex: place in the pixel and on the lens
  choose,  // opacity, lobe, light, Russian roulette
  move,    // direction of the next ray, place on the light
  medium,  // channel, distance, direction
  count,
};

// The numbers of a decision at the vertex that the path comes to.
inline std::uint32_t dimension_of(const LightPath& path, Decision decision) {
  return path.vertices * static_cast<std::uint32_t>(Decision::count) +
         static_cast<std::uint32_t>(decision);
}

// What chance says at a vertex, whatever that is.
struct VertexDraw {
  std::array<float, 4> choose, move;
  EnvironmentSample environment;  // for the last two of `move`
};

// Where chunks hold what the ray hit, or no value.
struct Described {
  const SurfaceChunk& chunk;
  std::optional<std::size_t> element;
};

// What a path that leaves a surface needs to know of it.
struct SurfacePlace {
  Vec3f position, normal;  // the geometric one
  float error = 0;         // see Surface
  MaterialId material{};
  bool from_outside = true;  // the path came from there
};

// A vertex whose reflectance waits to be computed with that of others.
struct PendingVertex {
  std::uint32_t path = 0;
  SurfacePlace place;
  LightSample light;
  bool asks_light = false;
  float u_survival = 0;
};
struct PendingVertices {
  std::array<PendingVertex, kChunk> vertices;
  std::size_t count = 0;
  BsdfChunk chunk;  // element i belongs to vertex i
};

class PathVertices {
 public:
  PathVertices(const PreparedScene& scene, const PathSampler& sampler,
               const RenderSettings& settings)
      : scene_(scene), lit_(scene.lit()), sampler_(sampler), settings_(settings) {}

  // Deals with the end of `ray`, which `hit` says, and makes the next ray. Light that may come
  // straight from a light source is put on `shadow_rays` for path number `index`. False when the
  // path ends here.
  // A vertex of a plain material is only put on `pending`, for finish().
  bool advance(std::uint32_t index, LightPath& path, Ray& ray, const Hit& hit,
               const Described& described, const VertexDraw& draw,
               std::vector<ShadowRay>& shadow_rays, PendingVertices& pending) const;
  // What advance() does with the reflectance, once element i of the chunk is computed.
  bool finish(const PendingVertices& pending, std::size_t i, LightPath& path, Ray& ray,
              std::vector<ShadowRay>& shadow_rays) const;

  // What the path sees of the environment, given its radiance there and the density of its own
  // sampling.
  void escape(const Vec3f& radiance, float environment_pdf, LightPath& path) const;
  // False when nothing of the environment counts for the path.
  bool sees_environment(const LightPath& path) const {
    return path.alpha != 0 || !settings_.transparent_background;
  }

 private:
  std::array<float, 4> numbers(const LightPath& path, Decision decision) const;
  bool scatter_in_medium(std::uint32_t index, LightPath& path, Ray& ray, float distance,
                         const Medium& medium, const VertexDraw& draw,
                         std::vector<ShadowRay>& shadow_rays) const;
  void add(const Vec3f& radiance, LightPath& path) const;
  void see_emission(const Surface& surface, const Ray& ray, float distance, LightPath& path) const;
  // Remembers in the path what choice there was.
  std::optional<LightSample> sample_light(const Vec3f& position, const Vec3f& normal,
                                          const VertexDraw& draw, LightPath& path) const;
  void ask_light(std::uint32_t index, LightPath& path, const Surface& surface, const Bsdf& bsdf,
                 const VertexDraw& draw, std::vector<ShadowRay>& shadow_rays) const;
  void postpone(std::uint32_t index, const Surface& surface, const Ray& ray, const VertexDraw& draw,
                LightPath& path, PendingVertices& pending) const;
  void add_shadow_ray(std::uint32_t index, const LightPath& path, const SurfacePlace& place,
                      const LightSample& light, const BsdfValue& value,
                      std::vector<ShadowRay>& shadow_rays) const;
  bool scatter(const SurfacePlace& place, const BsdfSample& sample, LightPath& path,
               Ray& ray) const;
  Vec3f through_medium(const SurfacePlace& place, const Vec3f& wi, float distance,
                       const LightPath& path) const;
  // To the side of the surface that wi points to.
  void pass_through(const SurfacePlace& place, const Vec3f& wi, Insides& insides) const;
  bool survives(float u, LightPath& path) const;

  const PreparedScene& scene_;
  const LitScene& lit_;
  const PathSampler& sampler_;
  const RenderSettings& settings_;
};

// The point from which a ray in direction `wi` leaves the surface without meeting it again.
[[nodiscard]] Vec3f leave_surface(const SurfacePlace& place, const Vec3f& wi);
[[nodiscard]] SurfacePlace place_of(const Surface& surface);

}  // namespace dapple
