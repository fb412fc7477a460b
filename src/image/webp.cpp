#include "image/webp.h"

#include <fmt/format.h>
#include <webp/decode.h>

#include "image/decoding.h"

namespace dapple {
namespace {

tl::unexpected<Error> damaged(const char* reason) {
  return fail(Errc::bad_data, "", std::string("damaged WebP: ") + reason);
}

const char* reason_of(VP8StatusCode status) {
  switch (status) {
    case VP8_STATUS_OUT_OF_MEMORY:
      return "out of memory";
    case VP8_STATUS_UNSUPPORTED_FEATURE:
      return "an unsupported feature";
    case VP8_STATUS_NOT_ENOUGH_DATA:
      return "the file ends early";
    default:
      return "its bit stream is invalid";
  }
}

}  // namespace

Expected<RawImage> decode_raw_webp(std::span<const std::byte> bytes, std::uint64_t max_pixels) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features{};
  const VP8StatusCode header = WebPGetFeatures(data, bytes.size(), &features);
  if (header != VP8_STATUS_OK) return damaged(reason_of(header));
  if (features.has_animation) return fail(Errc::bad_data, "", "animated WebP is not supported");
  // Sides are at most 16383; memory is taken only by files that libwebp found whole so far.
  RawImage image;
  image.width = static_cast<std::uint32_t>(features.width);
  image.height = static_cast<std::uint32_t>(features.height);
  const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
  if (auto allowed = check_picture_size(image.width, image.height, max_pixels); !allowed) {
    return tl::unexpected(allowed.error());
  }
  image.texels.resize(pixels * 4);
  const auto stride = static_cast<int>(image.width * 4);
  if (WebPDecodeRGBAInto(data, bytes.size(), image.texels.data(), image.texels.size(), stride) ==
      nullptr) {
    return damaged("its bit stream is invalid or ends early");
  }
  return image;
}

}  // namespace dapple
