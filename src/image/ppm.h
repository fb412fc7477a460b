// Portable pixel map. Writes binary PPM (P6) of 8 bits; reads P2, P3, P5 and P6, 8 and 16 bits.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/formats.h"

namespace dapple {

[[nodiscard]] Expected<std::vector<std::byte>> encode_ppm(const Image& image,
                                                          const ImageWriteOptions& options);
[[nodiscard]] Expected<Image> decode_ppm(std::span<const std::byte> bytes,
                                         const ImageReadOptions& options);

}  // namespace dapple
