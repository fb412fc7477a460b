#include "image/raw_image.h"

#include <cstring>
#include <new>
#include <string_view>

#include "image/exr.h"
#include "image/hdr.h"
#include "image/jpeg.h"
#include "image/png.h"
#include "image/webp.h"

namespace dapple {
namespace {

using Decode = Expected<RawImage> (*)(std::span<const std::byte>, std::uint64_t max_pixels);

Expected<RawImage> raw_from_linear(const Expected<Image>& image) {
  if (!image) return tl::unexpected(image.error());
  RawImage raw{static_cast<std::uint32_t>(image->width),
               static_cast<std::uint32_t>(image->height),
               RawFormat::rgb32f,
               {}};
  raw.texels.resize(image->pixels.size() * sizeof(Vec3f));
  std::memcpy(raw.texels.data(), image->pixels.data(), raw.texels.size());
  return raw;
}

Expected<RawImage> decode_raw_exr(std::span<const std::byte> bytes, std::uint64_t max_pixels) {
  return raw_from_linear(decode_exr(bytes, {Transfer::srgb, max_pixels}));
}

Expected<RawImage> decode_raw_hdr(std::span<const std::byte> bytes, std::uint64_t max_pixels) {
  return raw_from_linear(decode_hdr(bytes, {Transfer::srgb, max_pixels}));
}

Decode decoder_of(std::string_view content) {
  if (content.starts_with("\x89PNG\r\n\x1a\n")) return decode_raw_png;
  if (content.starts_with("\xff\xd8\xff")) return decode_raw_jpeg;
  if (content.starts_with("RIFF") && content.substr(0, 12).ends_with("WEBP")) {
    return decode_raw_webp;
  }
  if (content.starts_with("\x76\x2f\x31\x01")) return decode_raw_exr;
  if (content.starts_with("#?")) return decode_raw_hdr;
  return nullptr;
}

}  // namespace

Expected<RawImage> decode_raw_image(std::span<const std::byte> bytes,
                                    std::uint64_t max_pixels) try {
  const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const Decode decode = decoder_of(content);
  if (decode == nullptr) {
    return fail(Errc::bad_data, "", "not a picture in a known format (png, jpeg, webp, exr, hdr)");
  }
  return decode(bytes, max_pixels);
} catch (const std::bad_alloc&) {
  return fail(Errc::memory, "", "out of memory while the picture was decoded");
}

}  // namespace dapple
