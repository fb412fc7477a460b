// PNG, by libpng: writes 8 or 16 bits RGB with an sRGB or gAMA chunk; reads every colour type,
// honouring those chunks. Embedded colour profiles are ignored.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/formats.h"
#include "image/raw_image.h"

namespace dapple {

[[nodiscard]] Expected<std::vector<std::byte>> encode_png(const Image& image,
                                                          const ImageWriteOptions& options);
[[nodiscard]] Expected<Image> decode_png(std::span<const std::byte> bytes,
                                         const ImageReadOptions& options);
// The stored samples with alpha, 8 or 16 bits; gamma is ignored.
[[nodiscard]] Expected<RawImage> decode_raw_png(std::span<const std::byte> bytes,
                                                std::uint64_t max_pixels);

}  // namespace dapple
