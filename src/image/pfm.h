// Portable float map (PF): 32-bit floats, little-endian, bottom row first. Reads both byte orders
// and grey (Pf) too; the magnitude of the scale in its header multiplies the pixels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/formats.h"

namespace dapple {

[[nodiscard]] Expected<std::vector<std::byte>> encode_pfm(const Image& image,
                                                          const ImageWriteOptions& options);
[[nodiscard]] Expected<Image> decode_pfm(std::span<const std::byte> bytes,
                                         const ImageReadOptions& options);

}  // namespace dapple
