// WebP, by libwebp: reads lossy and lossless still pictures with alpha.
#pragma once

#include <cstddef>
#include <span>

#include "image/raw_image.h"

namespace dapple {

[[nodiscard]] Expected<RawImage> decode_raw_webp(std::span<const std::byte> bytes,
                                                 std::uint64_t max_pixels);

}  // namespace dapple
