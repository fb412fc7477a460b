// The bytes of a file's images, wherever they come from.
#pragma once

#include <deque>

#include "import/gltf/buffers.h"
#include "import/image_loader.h"

namespace dapple::gltf {

// Keeps what it gives out.
class Pictures {
 public:
  Pictures(const Context& context, Buffers& buffers) : context_(context), buffers_(buffers) {}

  // Still encoded. A type that differs from what the file says is a warning.
  [[nodiscard]] Expected<EncodedImage> encoded(std::uint32_t image);

 private:
  [[nodiscard]] Expected<std::span<const std::byte>> bytes(const JsonValue& image,
                                                           const std::string& pointer);

  const Context& context_;
  Buffers& buffers_;
  std::deque<MappedFile> files_;
  std::deque<std::vector<std::uint8_t>> data_;
};

// "image/png" and the like by the first bytes; empty when they are of no type that glTF knows.
[[nodiscard]] std::string_view image_type(std::span<const std::byte> bytes);

}  // namespace dapple::gltf
