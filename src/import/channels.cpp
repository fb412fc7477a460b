#include "import/channels.h"

#include <algorithm>
#include <cstring>

namespace dapple {
namespace {

// One channel of the pixel at (x, y) of a raster of another size, 0 to 255.
std::uint8_t channel(const RawImage& image, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                     std::uint32_t height, std::size_t which) {
  const std::uint64_t column = std::uint64_t{x} * image.width / width;
  const std::uint64_t row = std::uint64_t{y} * image.height / height;
  const std::uint8_t* pixel =
      image.texels.data() + (row * image.width + column) * raw_pixel_bytes(image.format);
  if (image.format == RawFormat::rgba8) return pixel[which];
  if (image.format == RawFormat::rgba16) return pixel[2 * which + 1];
  if (which == 3) return 255;
  float value = 0;
  std::memcpy(&value, pixel + which * sizeof value, sizeof value);
  return value > 0 ? static_cast<std::uint8_t>(std::min(value, 1.0f) * 255 + 0.5f) : 0;
}

// Calls fill(pixel, x, y, width, height) for each pixel of a picture as large as the larger one.
template <class Fill>
RawImage composed(const RawImage& a, const RawImage& b, Fill&& fill) {
  const bool first = std::uint64_t{a.width} * a.height >= std::uint64_t{b.width} * b.height;
  const RawImage& larger = first ? a : b;
  RawImage image{larger.width, larger.height, RawFormat::rgba8, {}};
  image.texels.resize(std::size_t{image.width} * image.height * 4, 255);
  std::uint8_t* pixel = image.texels.data();
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x, pixel += 4) {
      fill(pixel, x, y, image.width, image.height);
    }
  }
  return image;
}

}  // namespace

RawImage white_picture() { return {1, 1, RawFormat::rgba8, {255, 255, 255, 255}}; }

RawImage with_alpha(const RawImage& colour, const RawImage& alpha) {
  return composed(colour, alpha, [&](std::uint8_t* pixel, auto x, auto y, auto w, auto h) {
    for (std::size_t i = 0; i < 3; ++i) pixel[i] = channel(colour, x, y, w, h, i);
    pixel[3] = channel(alpha, x, y, w, h, 0);
  });
}

RawImage roughness_and_metallic(const RawImage& roughness, const RawImage& metallic) {
  return composed(roughness, metallic, [&](std::uint8_t* pixel, auto x, auto y, auto w, auto h) {
    pixel[1] = channel(roughness, x, y, w, h, 0);
    pixel[2] = channel(metallic, x, y, w, h, 0);
  });
}

bool looks_like_normals(const RawImage& picture) {
  constexpr std::uint32_t kSide = 64;  // this many samples across are enough
  std::uint32_t normals = 0;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    double n[3];
    for (std::size_t c = 0; c < 3; ++c) {
      n[c] = channel(picture, i % kSide, i / kSide, kSide, kSide, c) / 127.5 - 1;
    }
    const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (square > 0.7 && square < 1.3 && n[2] > 0) ++normals;
  }
  return normals > kSide * kSide * 3 / 4;
}

}  // namespace dapple
