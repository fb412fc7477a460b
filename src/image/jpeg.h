// JPEG, by libjpeg-turbo: reads grey, YCbCr, RGB, CMYK and YCCK, baseline or progressive.
#pragma once

#include <cstddef>
#include <span>

#include "image/raw_image.h"

namespace dapple {

[[nodiscard]] Expected<RawImage> decode_raw_jpeg(std::span<const std::byte> bytes,
                                                 std::uint64_t max_pixels);

}  // namespace dapple
