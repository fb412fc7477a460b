#include "import/gltf/material_reader.h"

namespace dapple::gltf {
namespace {

Vec3f rgb_or(const JsonValue& array, const Vec3f& otherwise) {
  Vec3f colour;
  for (int i = 0; i < 3; ++i) {
    colour[i] = static_cast<float>(array[static_cast<std::size_t>(i)].number_or(otherwise[i]));
  }
  return colour;
}

// Fills one material, extension by extension; keeps the first error.
class MaterialReader {
 public:
  MaterialReader(const JsonValue& json, std::string pointer, const Textures& textures)
      : json_(json), pointer_(std::move(pointer)), textures_(textures) {}

  Expected<LayeredMaterial> read() {
    core();
    specular_glossiness();
    surface_layers();
    inside();
    m_.unlit = extensions_.has("KHR_materials_unlit") ? 1 : 0;
    if (!status_) return tl::unexpected(status_.error());
    return m_;
  }

 private:
  using Json = JsonValue;

  static void number(const Json& from, const char* key, float& to) {
    to = static_cast<float>(from[key].number_or(to));
  }
  void map(const Json& from, const char* key, MapUse use, const std::string& below) {
    if (!status_ || !from.has(key)) return;
    const auto slot = textures_.slot(from[key], pointer_ + below + "/" + key);
    if (slot) {
      m_.map(use) = *slot;
    } else {
      status_ = tl::unexpected(slot.error());
    }
  }
  // An extension of the material; what it says lies `below` the material.
  const Json& extension(const char* name, std::string& below) const {
    below = std::string("/extensions/") + name;
    return extensions_[name];
  }

  void base(const Json& colour) {
    m_.base_colour = rgb_or(colour, {1, 1, 1});
    m_.alpha = static_cast<float>(colour[3].number_or(1));
  }

  void core() {
    const Json& pbr = json_["pbrMetallicRoughness"];
    base(pbr["baseColorFactor"]);
    m_.metallic = 1;
    number(pbr, "metallicFactor", m_.metallic);
    number(pbr, "roughnessFactor", m_.roughness);
    map(pbr, "baseColorTexture", MapUse::base_colour, "/pbrMetallicRoughness");
    map(pbr, "metallicRoughnessTexture", MapUse::metallic_roughness, "/pbrMetallicRoughness");
    map(json_, "normalTexture", MapUse::normal, "");
    number(json_["normalTexture"], "scale", m_.normal_scale);
    map(json_, "emissiveTexture", MapUse::emissive, "");
    std::string below;
    const double strength =
        extension("KHR_materials_emissive_strength", below)["emissiveStrength"].number_or(1);
    m_.emission = static_cast<float>(strength) * rgb_or(json_["emissiveFactor"], {});
    m_.double_sided = json_["doubleSided"].bool_or(false) ? 1 : 0;
    number(json_, "alphaCutoff", m_.alpha_cutoff);
    const std::string& mode = json_["alphaMode"].text();
    if (mode == "MASK") m_.alpha_mode = AlphaMode::mask;
    if (mode == "BLEND") m_.alpha_mode = AlphaMode::blend;
  }

  // Takes the place of the core's model.
  void specular_glossiness() {
    std::string below;
    const Json& e = extension("KHR_materials_pbrSpecularGlossiness", below);
    if (!e.is_object()) return;
    m_.model = BaseModel::specular_glossiness;
    m_.map(MapUse::base_colour) = {};
    m_.map(MapUse::metallic_roughness) = {};
    m_.metallic = 0;
    base(e["diffuseFactor"]);
    m_.specular_colour = rgb_or(e["specularFactor"], {1, 1, 1});
    number(e, "glossinessFactor", m_.glossiness);
    map(e, "diffuseTexture", MapUse::base_colour, below);
    map(e, "specularGlossinessTexture", MapUse::specular_glossiness, below);
  }

  void surface_layers() {
    std::string below;
    number(extension("KHR_materials_ior", below), "ior", m_.ior);
    if (const Json& e = extension("KHR_materials_specular", below); e.is_object()) {
      number(e, "specularFactor", m_.specular);
      m_.specular_colour = rgb_or(e["specularColorFactor"], {1, 1, 1});
      map(e, "specularTexture", MapUse::specular, below);
      map(e, "specularColorTexture", MapUse::specular_colour, below);
    }
    const Json& coat = extension("KHR_materials_clearcoat", below);
    number(coat, "clearcoatFactor", m_.clearcoat);
    number(coat, "clearcoatRoughnessFactor", m_.clearcoat_roughness);
    map(coat, "clearcoatTexture", MapUse::clearcoat, below);
    map(coat, "clearcoatRoughnessTexture", MapUse::clearcoat_roughness, below);
    map(coat, "clearcoatNormalTexture", MapUse::clearcoat_normal, below);
    number(coat["clearcoatNormalTexture"], "scale", m_.clearcoat_normal_scale);
    const Json& sheen = extension("KHR_materials_sheen", below);
    m_.sheen_colour = rgb_or(sheen["sheenColorFactor"], {});
    number(sheen, "sheenRoughnessFactor", m_.sheen_roughness);
    map(sheen, "sheenColorTexture", MapUse::sheen_colour, below);
    map(sheen, "sheenRoughnessTexture", MapUse::sheen_roughness, below);
    const Json& anisotropy = extension("KHR_materials_anisotropy", below);
    number(anisotropy, "anisotropyStrength", m_.anisotropy);
    number(anisotropy, "anisotropyRotation", m_.anisotropy_rotation);
    map(anisotropy, "anisotropyTexture", MapUse::anisotropy, below);
    const Json& film = extension("KHR_materials_iridescence", below);
    number(film, "iridescenceFactor", m_.iridescence);
    number(film, "iridescenceIor", m_.iridescence_ior);
    number(film, "iridescenceThicknessMinimum", m_.iridescence_min_nm);
    number(film, "iridescenceThicknessMaximum", m_.iridescence_max_nm);
    map(film, "iridescenceTexture", MapUse::iridescence, below);
    map(film, "iridescenceThicknessTexture", MapUse::iridescence_thickness, below);
  }

  // The thickness texture is not read: rays know how thick a body is.
  void inside() {
    std::string below;
    const Json& transmission = extension("KHR_materials_transmission", below);
    number(transmission, "transmissionFactor", m_.transmission);
    map(transmission, "transmissionTexture", MapUse::transmission, below);
    const Json& diffuse = extension("KHR_materials_diffuse_transmission", below);
    number(diffuse, "diffuseTransmissionFactor", m_.diffuse_transmission);
    m_.diffuse_transmission_colour = rgb_or(diffuse["diffuseTransmissionColorFactor"], {1, 1, 1});
    map(diffuse, "diffuseTransmissionTexture", MapUse::diffuse_transmission, below);
    map(diffuse, "diffuseTransmissionColorTexture", MapUse::diffuse_transmission_colour, below);
    number(extension("KHR_materials_dispersion", below), "dispersion", m_.dispersion);
    const Json& volume = extension("KHR_materials_volume", below);
    number(volume, "thicknessFactor", m_.thickness);
    number(volume, "attenuationDistance", m_.attenuation_distance);
    m_.attenuation_colour = rgb_or(volume["attenuationColor"], {1, 1, 1});
  }

  const Json& json_;
  const Json& extensions_ = json_["extensions"];
  std::string pointer_;
  const Textures& textures_;
  LayeredMaterial m_;
  Status status_;
};

}  // namespace

Expected<LayeredMaterial> read_material(const JsonValue& json, const std::string& pointer,
                                        const Textures& textures) {
  return MaterialReader(json, pointer, textures).read();
}

}  // namespace dapple::gltf
