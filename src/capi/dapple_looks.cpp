// Materials, textures and light of the C++ interface.
#include <cstring>

#include "capi/api_state.h"
#include "scene/validate.h"
#include "scene/validate_looks.h"

namespace dapple::v0 {
namespace {

Error bad_data(const std::string& message) {
  return {static_cast<int>(lib::Errc::bad_data), message};
}

float to_float(double x) { return static_cast<float>(x); }

LayeredMaterial to_lib(const Layered& m) {
  LayeredMaterial result;
  result.base_colour = to_vec3f(m.base_colour);
  result.alpha = to_float(m.alpha);
  result.alpha_mode = m.alpha < 1 ? AlphaMode::blend : AlphaMode::opaque;
  result.metallic = to_float(m.metallic);
  result.roughness = to_float(m.roughness);
  result.emission = to_vec3f(m.emission);
  result.ior = to_float(m.ior);
  result.specular = to_float(m.specular);
  result.specular_colour = to_vec3f(m.specular_colour);
  result.transmission = to_float(m.transmission);
  result.thickness = to_float(m.thickness);
  result.attenuation_distance = to_float(m.attenuation_distance);
  result.attenuation_colour = to_vec3f(m.attenuation_colour);
  result.clearcoat = to_float(m.clearcoat);
  result.clearcoat_roughness = to_float(m.clearcoat_roughness);
  result.sheen_colour = to_vec3f(m.sheen_colour);
  result.sheen_roughness = to_float(m.sheen_roughness);
  result.anisotropy = to_float(m.anisotropy);
  result.anisotropy_rotation = to_float(m.anisotropy_rotation);
  result.double_sided = m.double_sided ? 1 : 0;
  const auto use = [&](MapUse what, TextureId texture) {
    result.map(what).texture = static_cast<lib::TextureId>(texture);
  };
  use(MapUse::base_colour, m.base_colour_map);
  use(MapUse::metallic_roughness, m.metallic_roughness_map);
  use(MapUse::normal, m.normal_map);
  use(MapUse::emissive, m.emissive_map);
  return result;
}

lib::Material to_lib(const Material& material) {
  if (const auto* lambertian = std::get_if<Lambertian>(&material)) {
    return lib::Lambertian{to_vec3(lambertian->albedo)};
  }
  if (const auto* metal = std::get_if<Metal>(&material)) {
    return lib::Metal{to_vec3(metal->albedo), metal->fuzz};
  }
  return lib::Dielectric{std::get<Dielectric>(material).ref_idx};
}

// The texels as the next image of the scene, and a texture of it.
Result<TextureId> add_image(int width, int height, TexelFormat format,
                            std::span<const std::byte> texels, lib::Scene& scene) {
  const auto is_side = [](int side) { return side > 0 && side <= static_cast<int>(kMaxImageSide); };
  TextureImage image;
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  image.format = format;
  if (!is_side(width) || !is_side(height) || texels.size() != image.bytes()) {
    return bad_data("texture: its size is not allowed, or not that of its texels");
  }
  image.offset = (scene.texels.size() + 15) / 16 * 16;
  scene.texels.resize(image.offset + texels.size());
  std::memcpy(scene.texels.data() + image.offset, texels.data(), texels.size());
  scene.images.push_back(image);
  lib::Texture texture;
  texture.image = static_cast<ImageId>(scene.images.size() - 1);
  scene.textures.push_back(texture);
  return static_cast<TextureId>(scene.textures.size() - 1);
}

}  // namespace

Result<MaterialId> Scene::add_material(const Material& material) noexcept {
  return guarded([&]() -> Result<MaterialId> {
    lib::Scene& scene = own_state().scene;
    if (scene.materials.size() >= kMaxMaterialCount)
      return bad_data("material: there are too many");
    lib::Material added = lib::Layered{static_cast<std::uint32_t>(scene.layered_materials.size())};
    if (const auto* layered = std::get_if<Layered>(&material)) {
      const LayeredMaterial record = to_lib(*layered);
      const std::string reason = reason_against(record, scene.textures.size());
      if (!reason.empty()) return bad_data("material: " + reason);
      scene.layered_materials.push_back(record);
    } else {
      added = to_lib(material);
      if (auto status = validate(added); !status) return to_error(status.error());
    }
    return static_cast<MaterialId>(scene.add_material(added));
  });
}

Result<TextureId> Scene::add_texture(int width, int height,
                                     std::span<const std::uint8_t> rgba) noexcept {
  return guarded([&] {
    return add_image(width, height, TexelFormat::rgba8, std::as_bytes(rgba), own_state().scene);
  });
}

Result<TextureId> Scene::add_texture(int width, int height, std::span<const float> rgb) noexcept {
  return guarded([&] {
    return add_image(width, height, TexelFormat::rgb32f, std::as_bytes(rgb), own_state().scene);
  });
}

Status Scene::add_light(const Light& light) noexcept {
  return guarded([&]() -> Status {
    lib::Light added;
    added.kind = static_cast<LightKind>(light.kind);
    added.position = Vec3f(to_vec3(light.position));
    added.direction = Vec3f(normalize(to_vec3(light.direction)));
    added.intensity = to_vec3f(light.intensity);
    added.inner_angle = to_float(light.inner_angle);
    added.outer_angle = to_float(light.outer_angle);
    const std::string reason = reason_against(added);
    if (!reason.empty()) return bad_data("light: " + reason);
    own_state().scene.lights.push_back(added);
    return {};
  });
}

Status Scene::set_environment(const Environment& environment) noexcept {
  return guarded([&]() -> Status {
    lib::Scene& scene = own_state().scene;
    lib::Environment wanted;
    wanted.kind = static_cast<EnvironmentKind>(environment.kind);
    wanted.colour = to_vec3f(environment.colour);
    wanted.rotation = to_float(environment.rotation);
    if (environment.image != no_texture) {
      if (static_cast<std::size_t>(environment.image) >= scene.textures.size()) {
        return bad_data("environment: its image does not exist");
      }
      wanted.image = scene.textures[static_cast<std::size_t>(environment.image)].image;
    }
    const std::string reason = reason_against(wanted, scene.images.size());
    if (!reason.empty()) return bad_data("environment: " + reason);
    scene.environment = wanted;
    return {};
  });
}

}  // namespace dapple::v0
