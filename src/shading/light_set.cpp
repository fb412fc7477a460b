#include "shading/light_set.h"

#include <algorithm>
#include <limits>

#include "math/fast_functions.h"

namespace dapple {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float smooth_cone(const Light& light, float cosine) {
  const float inner = sin_cos(light.inner_angle).cos, outer = sin_cos(light.outer_angle).cos;
  const float t = std::clamp((cosine - outer) / std::max(inner - outer, 1e-4f), 0.0f, 1.0f);
  return t * t;
}

}  // namespace

LightSet::LightSet(const SceneView& scene, const TextureSet& textures,
                   const MaterialEvaluator& materials)
    : scene_(scene), materials_(&materials), environment_(scene, textures) {
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    lights_.push_back({Kind::lamp, {EmitterKind::triangle, i, kNoInstance}});
  }
  add_triangles(materials);
}

void LightSet::add_triangles(const MaterialEvaluator& materials) {
  const auto add = [&](std::uint32_t first, std::uint32_t count, std::uint32_t instance) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      if (!materials.is_emissive(scene_.triangle_materials[i])) continue;
      lights_.push_back({Kind::emitter, {EmitterKind::triangle, i, instance}});
    }
  };
  const auto world = scene_.prototypes.empty() ? static_cast<std::uint32_t>(scene_.triangles.size())
                                               : scene_.prototypes.front().first_triangle;
  add(0, world, kNoInstance);
  for (std::uint32_t i = 0; i < scene_.instances.size(); ++i) {
    const Prototype& prototype = scene_.prototypes[scene_.instances[i].prototype];
    add(prototype.first_triangle, prototype.triangle_count, i);
  }
}

float LightSet::environment_probability() const {
  if (environment_.is_black()) return 0;
  return lights_.empty() ? 1.0f : 0.5f;
}

float LightSet::light_probability() const {
  return lights_.empty() ? 0.0f
                         : (1.0f - environment_probability()) / static_cast<float>(lights_.size());
}

std::array<Vec3f, 3> LightSet::corners(const EmitterId& emitter) const {
  const Triangle& triangle = scene_.triangles[emitter.index];
  std::array<Vec3f, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = scene_.vertices.positions[triangle.vertices[i]];
    if (emitter.instance != kNoInstance) {
      result[i] = scene_.instances[emitter.instance].to_world.point(result[i]);
    }
  }
  return result;
}

std::optional<LightSample> LightSet::sample(const Vec3f& position, const Vec3f&, float u_choose,
                                            Vec2f u) const {
  const float p_environment = environment_probability();
  if (u_choose < p_environment) {
    const EnvironmentSample found = environment_.sample(u);
    if (!(found.pdf > 0.0f)) return std::nullopt;
    return LightSample{found.direction, kInfinity, found.radiance, found.pdf * p_environment,
                       false};
  }
  if (lights_.empty()) return std::nullopt;
  const float rest = (u_choose - p_environment) / (1.0f - p_environment);
  const auto index = std::min(static_cast<std::size_t>(rest * static_cast<float>(lights_.size())),
                              lights_.size() - 1);
  const Entry& entry = lights_[index];
  auto found = entry.kind == Kind::lamp ? sample_lamp(scene_.lights[entry.emitter.index], position)
                                        : sample_triangle(entry.emitter, position, u);
  if (found) found->pdf *= light_probability();
  return found;
}

std::optional<LightSample> LightSet::sample_lamp(const Light& light, const Vec3f& position) const {
  if (light.kind == LightKind::directional) {
    return LightSample{-light.direction, kInfinity, light.intensity, 1, true};
  }
  const Vec3f to_light = light.position - position;
  const float squared = dot(to_light, to_light);
  if (!(squared > 0.0f)) return std::nullopt;
  const float distance = std::sqrt(squared);
  const Vec3f wi = to_light / distance;
  const float cone =
      light.kind == LightKind::spot ? smooth_cone(light, -dot(wi, light.direction)) : 1.0f;
  if (!(cone > 0.0f)) return std::nullopt;
  return LightSample{wi, distance, (cone / squared) * light.intensity, 1, true};
}

std::optional<LightSample> LightSet::sample_triangle(const EmitterId& emitter,
                                                     const Vec3f& position, Vec2f u) const {
  const auto p = corners(emitter);
  const float root = std::sqrt(u.x);
  const float b0 = 1.0f - root, b1 = u.y * root, b2 = 1.0f - b0 - b1;
  const Vec3f point = b0 * p[0] + b1 * p[1] + b2 * p[2];
  const Vec3f scaled_normal = cross(p[1] - p[0], p[2] - p[0]);
  const float twice_area = length(scaled_normal);
  const Vec3f to_light = point - position;
  const float squared = dot(to_light, to_light);
  if (!(squared > 0.0f) || !(twice_area > 0.0f)) return std::nullopt;
  const float distance = std::sqrt(squared);
  const Vec3f wi = to_light / distance;
  const float cosine = std::fabs(dot(wi, scaled_normal)) / twice_area;
  if (!(cosine > 0.0f)) return std::nullopt;
  SurfaceInteraction at;
  const Triangle& triangle = scene_.triangles[emitter.index];
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    const auto& uvs = scene_.vertices.uvs[set];
    if (uvs.empty()) continue;
    at.uvs[set] = b0 * uvs[triangle.vertices[0]] + b1 * uvs[triangle.vertices[1]] +
                  b2 * uvs[triangle.vertices[2]];
  }
  const Vec3f radiance = materials_->emission(scene_.triangle_materials[emitter.index], at);
  return LightSample{wi, distance, radiance, 2.0f * squared / (cosine * twice_area), false};
}

float LightSet::pdf_of_hit(const EmitterId& emitter, const Vec3f&, const Vec3f&, const Vec3f& wi,
                           float distance, const Vec3f& light_normal) const {
  if (emitter.kind != EmitterKind::triangle) return 0;
  const auto p = corners(emitter);
  const float twice_area = length(cross(p[1] - p[0], p[2] - p[0]));
  const float cosine = std::fabs(dot(wi, light_normal));
  if (!(cosine * twice_area > 0.0f)) return 0;
  return light_probability() * 2.0f * distance * distance / (cosine * twice_area);
}

float LightSet::pdf_of_environment(const Vec3f&, const Vec3f&, const Vec3f& wi) const {
  return environment_probability() * environment_.pdf(wi);
}

}  // namespace dapple
