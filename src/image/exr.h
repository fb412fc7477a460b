// OpenEXR: writes R, G, B as half or float, ZIP compressed, with Rec.709 chromaticities; reads
// single-part files, scan lines or tiles, with R, G, B or Y channels. The picture is the data
// window.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/formats.h"

namespace dapple {

[[nodiscard]] Expected<std::vector<std::byte>> encode_exr(const Image& image,
                                                          const ImageWriteOptions& options);
[[nodiscard]] Expected<Image> decode_exr(std::span<const std::byte> bytes,
                                         const ImageReadOptions& options);

}  // namespace dapple
