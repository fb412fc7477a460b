// What the objects of a glTF file may hold, as tables.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace dapple::gltf {

enum class JsonKind { boolean, integer, number, text, object };

struct Schema;

// One member of an object; with `is_array` the limits are those of its items.
struct Property {
  std::string_view name;
  JsonKind kind = JsonKind::number;
  bool required = false;
  bool is_array = false;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;  // not `low` itself
  std::size_t least_items = 1;
  std::size_t most_items = static_cast<std::size_t>(-1);
  std::string_view refers{};  // the array of the root that an integer counts in
  const Schema* object = nullptr;
  std::string_view choices{};  // "|A|B|" of texts or integers
};

struct Schema {
  std::span<const Property> properties;
  std::string_view location;  // extensions are bound to such places: "material", "node"
};

// The root object of a file.
extern const Schema kRootSchema;
// What a material says of a texture.
extern const Schema kTextureInfoSchema;

// What an extension puts at a location, or nothing if it does not belong there.
const Schema* extension_schema(std::string_view extension, std::string_view location);
// True for the extensions that this importer honours.
bool is_known_extension(std::string_view extension);

}  // namespace dapple::gltf
