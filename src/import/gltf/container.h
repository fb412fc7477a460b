// The two forms of a glTF file: text, or a binary container of text and one buffer.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "util/error.h"

namespace dapple::gltf {

struct Container {
  std::string_view text;
  std::optional<std::span<const std::byte>> bin;  // the chunk that buffer 0 may be
  bool is_binary = false;
};

// The place of an error is "byte N".
[[nodiscard]] Expected<Container> split_container(std::span<const std::byte> file);

}  // namespace dapple::gltf
