#include "shading/light_set.h"

#include <algorithm>
#include <limits>

#include "math/fast_functions.h"
#include "shading/colour.h"

namespace dapple {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLeastShare = 0.1f;  // of a group that may give something

std::size_t kind_index(EmitterKind kind) { return static_cast<std::size_t>(kind); }

std::span<const MaterialId> materials_of(const SceneView& scene, EmitterKind kind) {
  if (kind == EmitterKind::sphere) return scene.sphere_materials;
  if (kind == EmitterKind::cylinder) return scene.cylinder_materials;
  return scene.rectangle_materials[kind_index(kind) - kind_index(EmitterKind::xy_rectangle)];
}

}  // namespace

LightSet::LightSet(const SceneView& scene, const TextureSet& textures,
                   const MaterialEvaluator& materials)
    : scene_(scene), materials_(&materials), shapes_(scene), environment_(scene, textures) {
  std::vector<LightBounds> bounds;
  for (const Light& light : scene.lights) {
    const Lamp lamp(light);
    if (!(luminance(light.intensity) > 0.0f)) continue;
    if (lamp.is_directional()) {
      directional_.push_back(lamp);
      directional_total_ += luminance(light.intensity);
    } else {
      near_.push_back({{}, static_cast<std::uint32_t>(lamps_.size())});
      lamps_.push_back(lamp);
      bounds.push_back(lamp.bounds());
    }
  }
  add_emitters(bounds);
  tree_ = LightTree(bounds);
  environment_total_ = kPi * luminance(environment_.mean_radiance());
}

// The power is what the shape shows of area, times its mean radiance. Where a texture is black on
// the whole, what the factor alone would give keeps a small part.
void LightSet::add_emitter(const EmitterId& emitter, std::vector<LightBounds>& bounds) {
  const MaterialId material = shapes_.material(emitter);
  const float mean = luminance(materials_->emission(material, shapes_.middle(emitter)));
  LightBounds light = shapes_.bounds(emitter);
  light.power *= std::max(mean, 0.01f * luminance(materials_->greatest_emission(material)));
  near_.push_back({emitter, kNone});
  bounds.push_back(light);
}

void LightSet::add_emitters(std::vector<LightBounds>& bounds) {
  for (std::size_t k = kind_index(EmitterKind::sphere); k < kEmitterKindCount; ++k) {
    const auto kind = static_cast<EmitterKind>(k);
    const auto materials = materials_of(scene_, kind);
    for (std::uint32_t i = 0; i < materials.size(); ++i) {
      if (!materials_->is_emissive(materials[i])) continue;
      near_of_[k].resize(materials.size(), kNone);
      near_of_[k][i] = static_cast<std::uint32_t>(near_.size());
      add_emitter({kind, i, kNoInstance}, bounds);
    }
  }
  add_triangles(bounds);
}

// What is missed of a dark triangle's light is still found by paths that meet it.
bool LightSet::triangle_shines(std::uint32_t index) const {
  const MaterialId material = scene_.triangle_materials[index];
  if (!materials_->is_emissive(material)) return false;
  const auto& uvs = scene_.vertices.uvs[materials_->emission_uv_set(material)];
  std::array<Vec2f, 3> corners;
  if (!uvs.empty()) {
    const auto& v = scene_.triangles[index].vertices;
    corners = {uvs[v[0]], uvs[v[1]], uvs[v[2]]};
  }
  return materials_->shines_within(material, corners);
}

void LightSet::add_triangles(std::vector<LightBounds>& bounds) {
  const auto& materials = scene_.triangle_materials;
  const auto shines = [&](std::uint32_t i) { return triangle_shines(i); };
  auto& of_world = near_of_[kind_index(EmitterKind::triangle)];
  const auto in_world = scene_.prototypes.empty() ? static_cast<std::uint32_t>(materials.size())
                                                  : scene_.prototypes.front().first_triangle;
  for (std::uint32_t i = 0; i < in_world; ++i) {
    if (!shines(i)) continue;
    of_world.resize(in_world, kNone);
    of_world[i] = static_cast<std::uint32_t>(near_.size());
    add_emitter({EmitterKind::triangle, i, kNoInstance}, bounds);
  }
  std::vector<bool> prototype_shines(scene_.prototypes.size());
  for (std::size_t p = 0; p < scene_.prototypes.size(); ++p) {
    const Prototype& prototype = scene_.prototypes[p];
    for (std::uint32_t i = 0; i < prototype.triangle_count && !prototype_shines[p]; ++i) {
      prototype_shines[p] = shines(prototype.first_triangle + i);
    }
  }
  for (std::uint32_t n = 0; n < scene_.instances.size(); ++n) {
    const std::uint32_t p = scene_.instances[n].prototype;
    if (!prototype_shines[p]) continue;
    first_of_instance_.resize(scene_.instances.size(), kNone);
    first_of_instance_[n] = static_cast<std::uint32_t>(near_of_instanced_.size());
    const Prototype& prototype = scene_.prototypes[p];
    for (std::uint32_t i = 0; i < prototype.triangle_count; ++i) {
      const std::uint32_t triangle = prototype.first_triangle + i;
      const bool lit = shines(triangle);
      near_of_instanced_.push_back(lit ? static_cast<std::uint32_t>(near_.size()) : kNone);
      if (lit) add_emitter({EmitterKind::triangle, triangle, n}, bounds);
    }
  }
}

std::uint32_t LightSet::near_index(const EmitterId& emitter) const {
  if (emitter.instance != kNoInstance) {
    if (emitter.instance >= first_of_instance_.size()) return kNone;
    const std::uint32_t first = first_of_instance_[emitter.instance];
    if (first == kNone) return kNone;
    const std::uint32_t p = scene_.instances[emitter.instance].prototype;
    return near_of_instanced_[first + emitter.index - scene_.prototypes[p].first_triangle];
  }
  const auto& of_kind = near_of_[kind_index(emitter.kind)];
  return emitter.index < of_kind.size() ? of_kind[emitter.index] : kNone;
}

LightSet::Groups LightSet::groups(const Vec3f& position, const Vec3f& normal) const {
  Groups result;
  if (tree_.empty() && directional_.empty()) {
    result.environment = environment_total_ > 0.0f ? 1.0f : 0.0f;
    return result;
  }
  if (!tree_.empty()) result.near = tree_.total_importance(position, normal);
  result.directional = directional_total_;
  result.environment = environment_total_;
  const float total = result.near + result.directional + result.environment;
  if (!(total > 0.0f)) return result;
  // Estimates: none that may give something gets too little.
  const auto share = [&](float value) { return value > 0.0f ? kLeastShare + value / total : 0.0f; };
  result = {share(result.near), share(result.directional), share(result.environment)};
  const float sum = result.near + result.directional + result.environment;
  return {result.near / sum, result.directional / sum, result.environment / sum};
}

std::optional<LightSample> LightSet::sample(const Groups& p, const Vec3f& position,
                                            const Vec3f& normal, float u_choose, Vec2f u,
                                            const EnvironmentSample& of_environment) const {
  std::optional<LightSample> found;
  float probability = 0;
  if (u_choose < p.near) {
    probability = p.near;
    found = sample_near(position, normal, u_choose / p.near, u);
  } else if (u_choose < p.near + p.directional) {
    probability = p.directional;
    found = sample_directional(position, (u_choose - p.near) / p.directional);
  } else if (p.environment > 0.0f && of_environment.pdf > 0.0f) {
    probability = p.environment;
    found = LightSample{of_environment.direction, kInfinity, of_environment.radiance,
                        of_environment.pdf, false};
  }
  if (found) found->pdf *= probability;
  return found;
}

std::optional<LightSample> LightSet::sample_near(const Vec3f& position, const Vec3f& normal,
                                                 float u_choose, Vec2f u) const {
  const auto choice = tree_.choose(position, normal, u_choose);
  if (!choice) return std::nullopt;
  const Near& light = near_[choice->light];
  if (light.lamp != kNone) {
    const auto arrival = lamps_[light.lamp].at(position);
    if (!arrival) return std::nullopt;
    return LightSample{arrival->wi, arrival->distance, arrival->irradiance, choice->probability,
                       true};
  }
  const auto point = shapes_.sample(light.emitter, position, u);
  if (!point) return std::nullopt;
  SurfaceInteraction at = point->surface;
  at.from_outside = dot(point->wi, at.geometric_normal) < 0;
  const Vec3f radiance = materials_->emission(shapes_.material(light.emitter), at);
  return LightSample{point->wi, point->distance, radiance, point->pdf * choice->probability, false};
}

std::optional<LightSample> LightSet::sample_directional(const Vec3f& position,
                                                        float u_choose) const {
  float left = u_choose * directional_total_;
  std::size_t i = 0;
  while (i + 1 < directional_.size() && left >= luminance(directional_[i].intensity())) {
    left -= luminance(directional_[i++].intensity());
  }
  const auto arrival = directional_[i].at(position);
  const float probability = luminance(directional_[i].intensity()) / directional_total_;
  return LightSample{arrival->wi, arrival->distance, arrival->irradiance, probability, true};
}

float LightSet::pdf_of_hit(const EmitterId& emitter, const Vec3f& position, const Vec3f& normal,
                           const Vec3f& wi, float distance, const Vec3f& light_normal) const {
  const std::uint32_t index = near_index(emitter);
  if (index == kNone) return 0;
  return groups(position, normal).near * tree_.probability(position, normal, index) *
         shapes_.pdf(emitter, position, wi, distance, light_normal);
}

float LightSet::pdf_of_environment(const Vec3f& position, const Vec3f& normal,
                                   const Vec3f& wi) const {
  const float share = groups(position, normal).environment;
  return share > 0.0f ? share * environment_.pdf(wi) : 0.0f;
}

}  // namespace dapple
