// The layered material at one point: textures looked up, factors multiplied in.
#pragma once

#include "scene/layered_material.h"
#include "shading/surface_interaction.h"
#include "shading/texture_set.h"

namespace dapple {

// Names and meanings are those of LayeredMaterial. Colours are clamped to where energy is kept.
struct LayeredPoint {
  Vec3f base_colour;
  float metallic = 0;
  float roughness = 1;
  Vec3f dielectric_f0{0.04f, 0.04f, 0.04f};
  float dielectric_f90 = 1;
  float ior = 1.5f;
  float dispersion = 0;
  float transmission = 0;
  bool thin = true;
  float diffuse_transmission = 0;
  Vec3f diffuse_transmission_colour;
  float clearcoat = 0;
  float clearcoat_roughness = 0;
  Vec3f sheen_colour;
  float sheen_roughness = 0;
  float iridescence = 0;
  float iridescence_ior = 1.3f;
  float iridescence_nm = 0;
  float anisotropy = 0;
  Vec2f anisotropy_direction{1, 0};  // unit, in tangent and bitangent
  Vec3f normal;                      // shading normals, world space, on the outward side
  Vec3f clearcoat_normal;
};

[[nodiscard]] LayeredPoint layered_point(const LayeredMaterial& material,
                                         const SurfaceInteraction& at, const TextureSet& textures);

// Base colour and alpha with texture and vertex colour.
[[nodiscard]] Vec4f base_colour(const LayeredMaterial& material, const SurfaceInteraction& at,
                                const TextureSet& textures);

}  // namespace dapple
