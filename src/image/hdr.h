// Radiance HDR: RGBE pixels, run-length encoded by scan line; reads the old encodings too, and
// divides by the EXPOSURE of the header.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/formats.h"

namespace dapple {

[[nodiscard]] Expected<std::vector<std::byte>> encode_hdr(const Image& image,
                                                          const ImageWriteOptions& options);
[[nodiscard]] Expected<Image> decode_hdr(std::span<const std::byte> bytes,
                                         const ImageReadOptions& options);

}  // namespace dapple
