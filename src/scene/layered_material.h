// One layered surface that covers glTF 2.0's metallic-roughness model and its extensions: from the
// outside in, sheen, clearcoat, a specular interface (dielectric or metal, anisotropic,
// iridescent), and below it diffuse reflection, diffuse transmission or a refracting volume.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "math/vec3.h"
#include "scene/texture.h"

namespace dapple {

// What a texture changes. Values multiply the material's factor, unless said otherwise.
enum class MapUse : std::uint32_t {
  base_colour,                  // rgb sRGB, a alpha; diffuse in the specular-glossiness model
  metallic_roughness,           // g roughness, b metallic
  specular_glossiness,          // rgb sRGB specular, a glossiness
  normal,                       // tangent space, xy scaled by normal_scale
  emissive,                     // rgb sRGB
  transmission,                 // r
  clearcoat,                    // r
  clearcoat_roughness,          // g
  clearcoat_normal,             // tangent space, xy scaled by clearcoat_normal_scale
  sheen_colour,                 // rgb sRGB
  sheen_roughness,              // a
  specular,                     // a
  specular_colour,              // rgb sRGB
  anisotropy,                   // rg direction in [-1, 1], b strength
  iridescence,                  // r
  iridescence_thickness,        // g: from the minimum to the maximum
  diffuse_transmission,         // a
  diffuse_transmission_colour,  // rgb sRGB
};
inline constexpr std::size_t kMapUseCount = 18;

// True when the rgb of an integer image is to be taken as sRGB.
constexpr bool is_colour_map(MapUse use) {
  return use == MapUse::base_colour || use == MapUse::specular_glossiness ||
         use == MapUse::emissive || use == MapUse::sheen_colour || use == MapUse::specular_colour ||
         use == MapUse::diffuse_transmission_colour;
}

// A texture in use: which one, by which coordinates, moved how.
struct TextureSlot {
  TextureId texture = kNoTexture;
  std::uint32_t uv_set = 0;
  float to_uv[2][3] = {{1, 0, 0}, {0, 1, 0}};  // applied to the vertex's (u, v, 1)
  friend bool operator==(const TextureSlot&, const TextureSlot&) = default;
};

enum class AlphaMode : std::uint32_t { opaque, mask, blend };
enum class BaseModel : std::uint32_t { metallic_roughness, specular_glossiness };

// Plain data, every colour linear. The defaults are a rough white dielectric.
struct LayeredMaterial {
  Vec3f base_colour{1, 1, 1};
  float alpha = 1;
  BaseModel model = BaseModel::metallic_roughness;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;       // of AlphaMode::mask
  std::uint32_t unlit = 0;         // 1: shows its base colour whatever the light
  std::uint32_t double_sided = 1;  // 0: not seen from behind
  float metallic = 0;
  float roughness = 1;  // its square is the width of the microfacet distribution
  float normal_scale = 1;
  Vec3f emission;                  // radiance, strength included
  float ior = 1.5f;                // 0: a mirror of the specular colour at every angle
  Vec3f specular_colour{1, 1, 1};  // at normal incidence; the whole F0 in specular-glossiness
  float specular = 1;
  float glossiness = 1;
  float transmission = 0;
  float dispersion = 0;  // 20 / Abbe number
  float diffuse_transmission = 0;
  Vec3f diffuse_transmission_colour{1, 1, 1};
  float clearcoat = 0;
  float clearcoat_roughness = 0;
  float clearcoat_normal_scale = 1;
  Vec3f sheen_colour;
  float sheen_roughness = 0;
  float anisotropy = 0;
  float anisotropy_rotation = 0;  // radians counter-clockwise from the tangent
  float iridescence = 0;
  float iridescence_ior = 1.3f;
  float iridescence_min_nm = 100;  // thickness of the film
  float iridescence_max_nm = 400;
  // The inside. A thickness of 0 is a thin wall: light goes through without being bent.
  float thickness = 0;
  float attenuation_distance = std::numeric_limits<float>::infinity();
  Vec3f attenuation_colour{1, 1, 1};  // what is left after attenuation_distance
  Vec3f scattering;                   // scattering coefficient, per unit of length
  float scattering_anisotropy = 0;    // g of Henyey and Greenstein, in (-1, 1)
  std::array<TextureSlot, kMapUseCount> maps{};

  const TextureSlot& map(MapUse use) const { return maps[static_cast<std::size_t>(use)]; }
  TextureSlot& map(MapUse use) { return maps[static_cast<std::size_t>(use)]; }
  friend bool operator==(const LayeredMaterial&, const LayeredMaterial&) = default;
};

}  // namespace dapple
