#include "image/ppm.h"

#include <fmt/format.h>

#include "image/transfer.h"

namespace dapple {

std::vector<std::byte> encode_ppm(const Image& image, Transfer transfer) {
  const std::string header = fmt::format("P6\n{} {}\n255\n", image.width, image.height);
  std::vector<std::byte> bytes;
  bytes.reserve(header.size() + image.pixels.size() * 3);
  for (const char c : header) bytes.push_back(static_cast<std::byte>(c));
  for (const Vec3f& pixel : image.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      bytes.push_back(static_cast<std::byte>(encode_integer(pixel[channel], transfer, 255)));
    }
  }
  return bytes;
}

}  // namespace dapple
