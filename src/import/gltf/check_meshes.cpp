#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "import/gltf/check.h"

namespace dapple::gltf {
namespace {

constexpr std::string_view kVariants = "KHR_materials_variants";
constexpr std::string_view kNames[] = {"POSITION", "NORMAL",  "TANGENT", "TEXCOORD_",
                                       "COLOR_",   "JOINTS_", "WEIGHTS_"};

bool is_attribute_name(std::string_view name) {
  if (name.starts_with('_')) return true;
  for (const std::string_view known : kNames) {
    if (!known.ends_with('_') && name == known) return true;
    if (!known.ends_with('_') || !name.starts_with(known)) continue;
    name.remove_prefix(known.size());
    const bool digits = !name.empty() && name.find_first_not_of("0123456789") == name.npos;
    return digits && (name.size() == 1 || name[0] != '0');
  }
  return false;
}

// "TEXCOORD_0" belongs to the set TEXCOORD_; the numbers of a set begin at 0 without gaps.
bool has_predecessor(const JsonValue& attributes, std::string_view name) {
  const std::size_t line = name.rfind('_');
  if (name.starts_with('_') || line == name.npos || name.substr(line + 1) == "0") return true;
  std::uint32_t number = 0;
  for (const char digit : name.substr(line + 1)) {
    number = number * 10 + static_cast<std::uint32_t>(digit - '0');
  }
  return attributes.has(fmt::format("{}_{}", name.substr(0, line), number - 1));
}

// KHR_texture_transform's number of the coordinates comes before the texture's own.
std::optional<std::uint32_t> texture_set(const JsonValue& info) {
  const JsonValue& transform = info["extensions"]["KHR_texture_transform"];
  return (transform.has("texCoord") ? transform : info)["texCoord"].index();
}

class MeshChecker {
 public:
  explicit MeshChecker(const Context& context)
      : context_(context), root_(context.document.root()) {}

  Status check() {
    const JsonValue& meshes = root_["meshes"];
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const JsonValue& primitives = meshes[m]["primitives"];
      const std::size_t targets = primitives[std::size_t{0}]["targets"].size();
      for (std::size_t p = 0; p < primitives.size(); ++p) {
        pointer_ = fmt::format("/meshes/{}/primitives/{}", m, p);
        warn_if(primitives[p]["targets"].size() != targets, "/targets",
                "differ in number from those of the first primitive");
        if (auto ok = primitive(primitives[p]); !ok) return ok;
      }
      pointer_ = fmt::format("/meshes/{}", m);
      warn_if(meshes[m].has("weights") && meshes[m]["weights"].size() != targets, "/weights",
              "differ in number from the morph targets");
    }
    return {};
  }

 private:
  [[nodiscard]] tl::unexpected<Error> error(const std::string& below, std::string message) const {
    return context_.document.error(pointer_ + below, std::move(message));
  }
  void warn_if(bool wrong, const std::string& below, const std::string& message) const {
    if (wrong) context_.warn(pointer_ + below, message);
  }
  const JsonValue& accessor(const JsonValue& number) const {
    return root_["accessors"][number.index().value_or(0xffffffffu)];
  }
  static std::uint64_t count_of(const JsonValue& accessor) {
    return accessor["count"].count().value_or(0);
  }

  Status primitive(const JsonValue& p) {
    const JsonValue& attributes = p["attributes"];
    const std::uint64_t count = count_of(accessor(attributes["POSITION"]));
    for (const JsonMember& attribute : attributes.members()) {
      if (auto ok = this->attribute(attributes, attribute, count, "/attributes"); !ok) return ok;
    }
    warn_if(attributes.has("JOINTS_0") != attributes.has("WEIGHTS_0") ||
                attributes.has("JOINTS_1") != attributes.has("WEIGHTS_1"),
            "/attributes", "joints and weights do not go together");
    warn_if(attributes.has("TANGENT") && !attributes.has("NORMAL"), "/attributes/TANGENT",
            "stands without NORMAL and is ignored");
    if (auto ok = indices(p); !ok) return ok;
    const JsonValue& targets = p["targets"];
    for (std::size_t t = 0; t < targets.size(); ++t) {
      const std::string below = fmt::format("/targets/{}", t);
      for (const JsonMember& attribute : targets[t].members()) {
        warn_if(!attributes.has(attribute.key), below + "/" + attribute.key,
                "the primitive itself has no such attribute");
        if (auto ok = this->attribute(targets[t], attribute, count, below); !ok) return ok;
      }
    }
    textures(p);
    variants(p);
    return {};
  }

  void variants(const JsonValue& p) const {
    const std::string below = "/extensions/" + std::string(kVariants);
    const JsonValue& declared = root_["extensions"][kVariants];
    if (!p["extensions"].has(kVariants)) return;
    warn_if(!declared.is_object(), below, "the root of the file names no variants");
    std::set<std::uint32_t> mapped;
    for (const JsonValue& mapping : p["extensions"][kVariants]["mappings"].items()) {
      for (const JsonValue& item : mapping["variants"].items()) {
        const std::uint32_t variant = item.index().value_or(0xffffffffu);
        warn_if(!mapped.insert(variant).second, below,
                fmt::format("maps variant {} twice; the first counts", variant));
        warn_if(declared.is_object() && variant >= declared["variants"].size(), below,
                fmt::format("variant {} does not exist", variant));
      }
    }
  }

  Status attribute(const JsonValue& attributes, const JsonMember& attribute, std::uint64_t count,
                   const std::string& where) {
    const std::string below = where + "/" + attribute.key;
    const JsonValue& a = accessor(attribute.value);
    if (a.is_null()) return error(below, "the accessor does not exist");
    if (!is_attribute_name(attribute.key)) {
      warn_if(true, below, "is not the name of an attribute and is ignored");
      return {};
    }
    warn_if(!has_predecessor(attributes, attribute.key), below, "its number leaves a gap");
    if (count != 0 && count_of(a) != count) {
      return error(
          below, fmt::format("it has {} elements where there are {} vertices", count_of(a), count));
    }
    warn_if(a["componentType"].count() == 5125u, below,
            "attributes have no components of UNSIGNED_INT");
    if (attribute.key == "POSITION" || attribute.key == "NORMAL") {
      if (a["type"].text() != "VEC3") return error(below, "is not a VEC3");
      warn_if(attribute.key == "POSITION" && !(a.has("min") && a.has("max")), below,
              "its accessor has no min and max");
      const bool quantised = a["componentType"].count() != 5126u;
      warn_if(quantised && !is_required("KHR_mesh_quantization"), below,
              "integers need KHR_mesh_quantization among extensionsRequired");
    }
    vertex_view(a, below, attribute.value.index().value_or(0));
    return {};
  }

  // The buffer view of an attribute.
  void vertex_view(const JsonValue& a, const std::string& below, std::uint32_t accessor_number) {
    const auto number = a["bufferView"].index();
    const JsonValue& view = root_["bufferViews"][number.value_or(0xffffffffu)];
    if (view.is_null()) return;
    warn_if(view["target"].count() == 34963u, below, "its buffer view is one for indices");
    const auto packed = element_size(a["componentType"].count().value_or(0), a["type"].text()).step;
    const std::uint64_t offset =
        a["byteOffset"].count().value_or(0) + view["byteOffset"].count().value_or(0);
    warn_if((offset | view["byteStride"].count().value_or(packed)) % 4 != 0, below,
            "its elements do not begin at multiples of four bytes");
    const auto [first, is_new] = first_attribute_.try_emplace(*number, accessor_number);
    if (is_new || first->second == accessor_number || view.has("byteStride")) return;
    context_.warn(fmt::format("/bufferViews/{}", *number),
                  "several attributes share it, so it needs a byteStride");
  }

  bool is_required(std::string_view name) const {
    const auto& required = root_["extensionsRequired"].items();
    return std::any_of(required.begin(), required.end(),
                       [&](const JsonValue& item) { return item.text() == name; });
  }

  Status indices(const JsonValue& p) {
    if (!p.has("indices")) return {};
    const JsonValue& a = accessor(p["indices"]);
    const auto type = a["componentType"].count();
    if (a["type"].text() != "SCALAR" || (type != 5121u && type != 5123u && type != 5125u)) {
      return error("/indices", "is not of unsigned integers");
    }
    const std::uint32_t number = a["bufferView"].index().value_or(0xffffffffu);
    const JsonValue& view = root_["bufferViews"][number];
    warn_if(first_attribute_.contains(number), "/indices",
            "its buffer view holds attributes of vertices too");
    warn_if(view.has("byteStride"), "/indices", "indices have no stride");
    warn_if(view["target"].count() == 34962u, "/indices", "its buffer view is one for vertices");
    return {};
  }

  // Every texture of the material finds its coordinates.
  void textures(const JsonValue& p) const {
    const JsonValue& material = root_["materials"][p["material"].index().value_or(0xffffffffu)];
    std::uint32_t sets = 0;
    while (p["attributes"].has(fmt::format("TEXCOORD_{}", sets))) ++sets;
    look_for_textures(material, sets);
    const JsonValue& extensions = material["extensions"];
    const bool by_extension = extensions.has("KHR_materials_anisotropy") ||
                              extensions["KHR_materials_clearcoat"].has("clearcoatNormalTexture");
    const bool has_map = material.has("normalTexture");
    if (p["attributes"].has("TANGENT") || !(by_extension || has_map)) return;
    warn_if(sets == 0, "",
            "its material needs tangents, which neither it nor texture coordinates give");
    warn_if(
        sets > 0 && !has_map, "",
        "its material needs tangents; without a normal map to say which, they follow the texture "
        "coordinates");
  }
  void look_for_textures(const JsonValue& value, std::uint32_t sets) const {
    for (const JsonMember& member : value.members()) {
      if (member.key == "extras") continue;
      if (member.key.ends_with("Texture") && member.value.is_object()) {
        const std::uint32_t set = texture_set(member.value).value_or(0);
        warn_if(set >= sets, "",
                fmt::format("{} of its material needs TEXCOORD_{}", member.key, set));
      }
      look_for_textures(member.value, sets);
    }
  }

  const Context& context_;
  const JsonValue& root_;
  std::string pointer_;  // of the primitive that is being checked
  std::map<std::uint32_t, std::uint32_t> first_attribute_;  // accessor by buffer view
};

}  // namespace

Status check_meshes(const Context& context) { return MeshChecker(context).check(); }

}  // namespace dapple::gltf
