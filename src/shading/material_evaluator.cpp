#include "shading/material_evaluator.h"

#include <algorithm>

#include "math/fast_functions.h"
#include "shading/bsdf_builder.h"
#include "shading/colour.h"

namespace dapple {

MaterialEvaluator::MaterialEvaluator(const SceneView& scene, const TextureSet& textures)
    : scene_(scene), traits_(scene.materials.size()), textures_(textures) {
  for (std::size_t i = 0; i < traits_.size(); ++i) {
    const auto* reference = std::get_if<Layered>(&scene.materials[i]);
    if (reference == nullptr) continue;
    const LayeredMaterial& m = scene.layered_materials[reference->index];
    Traits& traits = traits_[i];
    traits.layered = &m;
    traits.plain = !(m.iridescence > 0) && !(m.transmission > 0 && m.dispersion > 0);
    traits.transparent = m.alpha_mode != AlphaMode::opaque;
    traits.emissive = max_component(m.emission) > 0;
    traits.unlit = m.unlit != 0;
    traits.interior = m.thickness > 0 && (m.transmission > 0 || m.diffuse_transmission > 0);
  }
}

Bsdf MaterialEvaluator::make_bsdf(MaterialId material, const SurfaceInteraction& at,
                                  const Vec3f& wo, DispersionChannel dispersion) const {
  BsdfBuilder builder(at, wo);
  const LayeredMaterial* m = layered(material);
  if (m == nullptr) return builder.classic(scene_.materials[index_of(material)]);
  return builder.layered(layered_point(*m, at, textures_), dispersion);
}

float MaterialEvaluator::opacity(MaterialId material, const SurfaceInteraction& at) const {
  const LayeredMaterial* m = layered(material);
  if (m == nullptr || m->alpha_mode == AlphaMode::opaque) return 1;
  const float alpha = base_colour(*m, at, textures_).w;
  if (m->alpha_mode == AlphaMode::mask) return alpha >= m->alpha_cutoff ? 1.0f : 0.0f;
  return std::clamp(alpha, 0.0f, 1.0f);
}

Vec3f MaterialEvaluator::emission(MaterialId material, const SurfaceInteraction& at) const {
  const LayeredMaterial* m = layered(material);
  if (m == nullptr || m->emission == Vec3f()) return {};
  if (m->double_sided == 0 && !at.from_outside) return {};
  return m->emission * textures_.lookup(m->map(MapUse::emissive), MapUse::emissive, at).xyz();
}

bool MaterialEvaluator::shines_within(MaterialId material,
                                      const std::array<Vec2f, 3>& corners) const {
  const LayeredMaterial* m = layered(material);
  return m != nullptr && !textures_.is_black(m->map(MapUse::emissive), MapUse::emissive, corners);
}

std::uint32_t MaterialEvaluator::emission_uv_set(MaterialId material) const {
  const LayeredMaterial* m = layered(material);
  return m == nullptr ? 0 : m->map(MapUse::emissive).uv_set;
}

Vec3f MaterialEvaluator::greatest_emission(MaterialId material) const {
  const LayeredMaterial* m = layered(material);
  return m == nullptr ? Vec3f() : m->emission;
}

Vec3f MaterialEvaluator::unlit_colour(MaterialId material, const SurfaceInteraction& at) const {
  const LayeredMaterial* m = layered(material);
  if (m == nullptr) return {};
  return base_colour(*m, at, textures_).xyz();
}

Medium MaterialEvaluator::interior(MaterialId material) const {
  const LayeredMaterial* m = layered(material);
  if (m == nullptr || !has_interior(material)) return {};
  Medium medium{{}, m->scattering, m->scattering_anisotropy};
  if (!(m->attenuation_distance < 1e30f)) return medium;
  const auto absorption = [&](float left) {
    return -fast_log(std::clamp(left, 1e-6f, 1.0f)) / std::max(m->attenuation_distance, 1e-9f);
  };
  const Vec3f& c = m->attenuation_colour;
  medium.absorption = {absorption(c.x), absorption(c.y), absorption(c.z)};
  return medium;
}

}  // namespace dapple
