// How the elements of an accessor lie in bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace dapple::gltf {

enum ComponentType : std::uint64_t {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
};

// Number of components of "SCALAR", "VEC3", "MAT4" and so on; 0 if unknown.
std::size_t component_count(std::string_view type);
// Bytes of a component type by its OpenGL number; 0 if unknown.
std::size_t component_bytes(std::uint64_t component_type);

// Bytes from one packed element to the next, and of the last one; 0 if unknown.
struct ElementSize {
  std::size_t step = 0;
  std::size_t last = 0;
};
ElementSize element_size(std::uint64_t component_type, std::string_view type);

// How the elements of an accessor, or of its sparse part, lie in bytes.
struct Layout {
  std::uint64_t component_type = 0;
  std::size_t components = 0;
  std::size_t rows = 0;          // of a column; all of them for vectors
  std::size_t column_bytes = 0;  // columns of matrices begin at multiples of four bytes
  std::size_t element_bytes = 0;
  std::size_t used_bytes = 0;  // without what fills up the last column
  std::size_t stride = 0;
  std::size_t offset = 0;
  bool normalised = false;
};
// Without gaps between the elements; element_bytes is 0 if a type is unknown.
Layout packed_layout(std::uint64_t component_type, std::string_view type);

}  // namespace dapple::gltf
