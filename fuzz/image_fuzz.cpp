// Any bytes as a picture: an error or a picture that can be written again, never a crash.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "image/formats.h"

namespace {

constexpr dapple::ImageReadOptions kLimits{dapple::Transfer::srgb, 1 << 18};

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto image =
      dapple::decode_image({reinterpret_cast<const std::byte*>(data), size}, kLimits);
  if (!image) return 0;
  require(image->width > 0 && image->height > 0);
  require(image->pixels.size() ==
          static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height));
  if (image->pixels.size() > 4096) return 0;
  for (const char* name : {".ppm", ".png", ".exr", ".pfm", ".hdr"}) {
    const auto bytes = dapple::encode_image(name, *image, {});
    require(bytes.has_value());
    require(dapple::decode_image(*bytes).has_value());
  }
  return 0;
}
