// A picture as its file stores it: no curve applied, alpha kept. What textures are made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "util/error.h"

namespace dapple {

enum class RawFormat : std::uint32_t {
  rgba8,   // four bytes
  rgba16,  // four 16-bit integers, little-endian
  rgb32f,  // three floats, linear; alpha is left out
};

constexpr std::uint64_t raw_pixel_bytes(RawFormat format) {
  return format == RawFormat::rgba8 ? 4 : format == RawFormat::rgba16 ? 8 : 12;
}

struct RawImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  RawFormat format = RawFormat::rgba8;
  std::vector<std::uint8_t> texels;  // rows from the top without gaps
};

// PNG, JPEG, WebP, EXR and HDR, recognised by content. Grey becomes rgb, a missing alpha is opaque.
// Colour profiles and gamma chunks are ignored: what the numbers mean is the use's to say.
[[nodiscard]] Expected<RawImage> decode_raw_image(std::span<const std::byte> bytes,
                                                  std::uint64_t max_pixels = 1ull << 28);

}  // namespace dapple
