#include "shading/layered_point.h"

#include <algorithm>

#include "math/fast_functions.h"
#include "shading/colour.h"
#include "shading/fresnel.h"

namespace dapple {
namespace {

float unit(float x) { return std::clamp(x, 0.0f, 1.0f); }
Vec3f unit(const Vec3f& c) { return {unit(c.x), unit(c.y), unit(c.z)}; }

// Lookups of one material at one point.
struct Maps {
  const LayeredMaterial& material;
  const SurfaceInteraction& at;
  const TextureSet& textures;

  bool has(MapUse use) const { return material.map(use).texture != kNoTexture; }
  Vec4f operator()(MapUse use) const {
    const TextureSlot& slot = material.map(use);
    return slot.texture == kNoTexture ? Vec4f{1, 1, 1, 1} : textures.lookup(slot, use, at);
  }
};

// The normal that a tangent-space map asks for.
Vec3f mapped_normal(const Maps& maps, MapUse use, float scale) {
  const SurfaceInteraction& at = maps.at;
  if (!maps.has(use)) return at.shading_normal;
  const Vec4f texel = maps(use);
  const float x = scale * (2.0f * texel.x - 1.0f), y = scale * (2.0f * texel.y - 1.0f);
  const float z = std::max(2.0f * texel.z - 1.0f, 0.01f);
  const Vec3f bitangent = at.bitangent_sign * cross(at.shading_normal, at.tangent);
  return normalize(x * at.tangent + y * bitangent + z * at.shading_normal);
}

void metallic_roughness(LayeredPoint& point, const Maps& maps) {
  const LayeredMaterial& m = maps.material;
  const Vec4f map = maps(MapUse::metallic_roughness);
  point.metallic = unit(m.metallic * map.z);
  point.roughness = unit(m.roughness * map.y);
  const float specular = unit(m.specular * maps(MapUse::specular).w);
  const Vec3f colour = m.specular_colour * maps(MapUse::specular_colour).xyz();
  point.dielectric_f0 = specular * unit(f0_of_ior(m.ior) * colour);
  point.dielectric_f90 = specular;
}

void specular_glossiness(LayeredPoint& point, const Maps& maps) {
  const LayeredMaterial& m = maps.material;
  const Vec4f map = maps(MapUse::specular_glossiness);
  point.roughness = 1.0f - unit(m.glossiness * map.w);
  point.dielectric_f0 = unit(m.specular_colour * map.xyz());
}

void transmission(LayeredPoint& point, const Maps& maps) {
  const LayeredMaterial& m = maps.material;
  point.ior = m.ior;
  point.thin = !(m.thickness > 0.0f);
  if (m.transmission > 0.0f) {
    point.transmission = unit(m.transmission * maps(MapUse::transmission).x);
    point.dispersion = m.dispersion;
  }
  if (m.diffuse_transmission > 0.0f) {
    point.diffuse_transmission =
        unit(m.diffuse_transmission * maps(MapUse::diffuse_transmission).w);
    point.diffuse_transmission_colour =
        unit(m.diffuse_transmission_colour * maps(MapUse::diffuse_transmission_colour).xyz());
  }
}

void coatings(LayeredPoint& point, const Maps& maps) {
  const LayeredMaterial& m = maps.material;
  if (m.clearcoat > 0.0f) {
    point.clearcoat = unit(m.clearcoat * maps(MapUse::clearcoat).x);
    point.clearcoat_roughness = unit(m.clearcoat_roughness * maps(MapUse::clearcoat_roughness).y);
    point.clearcoat_normal =
        mapped_normal(maps, MapUse::clearcoat_normal, m.clearcoat_normal_scale);
  }
  if (max_component(m.sheen_colour) > 0.0f) {
    point.sheen_colour = unit(m.sheen_colour * maps(MapUse::sheen_colour).xyz());
    point.sheen_roughness = unit(m.sheen_roughness * maps(MapUse::sheen_roughness).w);
  }
  if (m.iridescence > 0.0f) {
    point.iridescence = unit(m.iridescence * maps(MapUse::iridescence).x);
    point.iridescence_ior = std::max(m.iridescence_ior, 1.0f);
    point.iridescence_nm =
        mix(m.iridescence_min_nm, m.iridescence_max_nm, maps(MapUse::iridescence_thickness).y);
  }
}

void anisotropy(LayeredPoint& point, const Maps& maps) {
  const LayeredMaterial& m = maps.material;
  if (!(m.anisotropy > 0.0f)) return;
  const SinCos<float> turned = sin_cos(m.anisotropy_rotation);
  point.anisotropy = unit(m.anisotropy);
  point.anisotropy_direction = {turned.cos, turned.sin};
  if (!maps.has(MapUse::anisotropy)) return;
  const Vec4f map = maps(MapUse::anisotropy);
  const float x = 2.0f * map.x - 1.0f, y = 2.0f * map.y - 1.0f;
  const float squared = x * x + y * y;
  point.anisotropy = unit(m.anisotropy * map.z);
  if (!(squared > 1e-8f)) return;
  const float scale = 1.0f / std::sqrt(squared);
  point.anisotropy_direction = {scale * (turned.cos * x - turned.sin * y),
                                scale * (turned.sin * x + turned.cos * y)};
}

}  // namespace

Vec4f base_colour(const LayeredMaterial& material, const SurfaceInteraction& at,
                  const TextureSet& textures) {
  const Vec4f map = Maps{material, at, textures}(MapUse::base_colour);
  const Vec3f rgb = material.base_colour * map.xyz() * at.colour.xyz();
  return {rgb.x, rgb.y, rgb.z, material.alpha * map.w * at.colour.w};
}

LayeredPoint layered_point(const LayeredMaterial& material, const SurfaceInteraction& at,
                           const TextureSet& textures) {
  const Maps maps{material, at, textures};
  LayeredPoint point;
  point.base_colour = unit(base_colour(material, at, textures).xyz());
  if (material.model == BaseModel::metallic_roughness) {
    metallic_roughness(point, maps);
  } else {
    specular_glossiness(point, maps);
  }
  point.normal = mapped_normal(maps, MapUse::normal, material.normal_scale);
  transmission(point, maps);
  coatings(point, maps);
  anisotropy(point, maps);
  return point;
}

}  // namespace dapple
