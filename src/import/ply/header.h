// The header of a PLY file: which elements follow, and how each is stored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "util/error.h"

namespace dapple::ply {

enum class Format { ascii, little_endian, big_endian };
enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

constexpr std::size_t bytes_of(Type type) {
  constexpr std::size_t kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Type type = Type::f32;
  bool is_list = false;
  Type count_type = Type::u8;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  // The least that one of them can take in a file.
  std::size_t min_bytes(Format format) const;
};

struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
  std::string texture_file;  // of a comment "TextureFile NAME", or empty
  std::size_t bytes = 0;     // of the header itself
  std::size_t lines = 0;
};

inline constexpr std::size_t kMaxElements = 64;
inline constexpr std::size_t kMaxProperties = 256;

// `name` is the file's, for errors. That the file is long enough for all elements is checked.
[[nodiscard]] Expected<Header> read_header(std::span<const std::byte> bytes, std::string_view name);

}  // namespace dapple::ply
