#include "import/gltf/accessor_layout.h"

#include <utility>

namespace dapple::gltf {
namespace {

std::size_t row_count(std::string_view type) {
  return type.starts_with("MAT") ? static_cast<std::size_t>(type[3] - '0') : component_count(type);
}

}  // namespace

std::size_t component_count(std::string_view type) {
  constexpr std::pair<std::string_view, std::size_t> kTypes[] = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
  for (const auto& [name, count] : kTypes) {
    if (name == type) return count;
  }
  return 0;
}

std::size_t component_bytes(std::uint64_t component_type) {
  switch (component_type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

Layout packed_layout(std::uint64_t component_type, std::string_view type) {
  Layout layout;
  layout.component_type = component_type;
  layout.components = component_count(type);
  if (layout.components == 0) return layout;
  layout.rows = row_count(type);
  layout.column_bytes = layout.rows * component_bytes(component_type);
  const std::size_t columns = layout.components / layout.rows;
  if (columns > 1) layout.column_bytes = (layout.column_bytes + 3) / 4 * 4;
  layout.element_bytes = layout.column_bytes * columns;
  layout.used_bytes =
      layout.column_bytes * (columns - 1) + layout.rows * component_bytes(component_type);
  layout.stride = layout.element_bytes;
  return layout;
}

ElementSize element_size(std::uint64_t component_type, std::string_view type) {
  const Layout layout = packed_layout(component_type, type);
  return {layout.element_bytes, layout.used_bytes};
}

}  // namespace dapple::gltf
