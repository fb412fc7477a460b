#include "import/gltf/materials.h"

#include <fmt/format.h>

#include "import/gltf/material_reader.h"

namespace dapple::gltf {
namespace {

constexpr const char* kVariants = "KHR_materials_variants";

// The number of the chosen variant, or nothing.
std::optional<std::uint32_t> chosen_variant(const Context& context) {
  const JsonValue& variants = context.document["extensions"][kVariants]["variants"];
  if (context.options.variant.empty()) return std::nullopt;
  for (std::uint32_t i = 0; i < variants.size(); ++i) {
    if (variants[i]["name"].text() == context.options.variant) return i;
  }
  return std::nullopt;
}

// What a primitive shows under that variant: a material number, or its own.
const JsonValue& material_of(const JsonValue& primitive, std::optional<std::uint32_t> variant) {
  const JsonValue& mappings = primitive["extensions"][kVariants]["mappings"];
  for (const JsonValue& mapping : mappings.items()) {
    for (const JsonValue& number : mapping["variants"].items()) {
      if (variant && number.index() == *variant) return mapping["material"];
    }
  }
  return primitive["material"];
}

// Without a material: glTF's default is a white, rough metal.
LayeredMaterial default_material() {
  LayeredMaterial material;
  material.metallic = 1;
  material.double_sided = 0;
  return material;
}

}  // namespace

Status check_variant(const Context& context) {
  if (context.options.variant.empty() || chosen_variant(context)) return {};
  std::string names;
  for (const JsonValue& known : context.document["extensions"][kVariants]["variants"].items()) {
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", known["name"].text());
  }
  return fail(Errc::usage, context.document.place(""),
              fmt::format("the file has no variant \"{}\"; it has {}", context.options.variant,
                          names.empty() ? "none" : names));
}

std::set<std::uint32_t> materials_in_use(const Context& context,
                                         const std::vector<PlacedNode>& nodes) {
  const Document& document = context.document;
  const auto variant = chosen_variant(context);
  std::set<std::uint32_t> meshes, materials;
  for (const PlacedNode& node : nodes) {
    const auto mesh = document["nodes"][node.index]["mesh"].index();
    if (mesh) meshes.insert(*mesh);
  }
  for (const std::uint32_t mesh : meshes) {
    for (const JsonValue& primitive : document["meshes"][mesh]["primitives"].items()) {
      const auto material = material_of(primitive, variant).index();
      if (material) materials.insert(*material);
    }
  }
  return materials;
}

Expected<LayeredMaterial> Materials::of_primitive(const JsonValue& primitive,
                                                  const std::string& pointer) {
  const JsonValue& number = material_of(primitive, chosen_variant(context_));
  if (number.is_null()) return default_material();
  const auto index = number.index();
  if (!index || *index >= context_.document["materials"].size()) {
    return context_.document.error(pointer + "/material", "the material does not exist");
  }
  const auto known = known_.find(*index);
  if (known != known_.end()) return known->second;
  auto material = read(*index);
  if (material) known_[*index] = *material;
  return material;
}

Expected<LayeredMaterial> Materials::read(std::uint32_t index) const {
  return read_material(context_.document["materials"][index], fmt::format("/materials/{}", index),
                       textures_);
}

bool needs_tangents(const LayeredMaterial& material) {
  return material.map(MapUse::normal).texture != kNoTexture ||
         material.map(MapUse::clearcoat_normal).texture != kNoTexture || material.anisotropy != 0;
}

std::uint32_t tangent_uv_set(const LayeredMaterial& material) {
  for (const MapUse use : {MapUse::normal, MapUse::clearcoat_normal, MapUse::anisotropy}) {
    if (material.map(use).texture != kNoTexture) return material.map(use).uv_set;
  }
  return 0;
}

}  // namespace dapple::gltf
