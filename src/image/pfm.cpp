#include "image/pfm.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "image/decoding.h"

namespace dapple {
namespace {

struct Header {
  std::uint32_t width = 0, height = 0;
  double scale = -1;  // negative: little-endian
};

Expected<Header> read_header(HeaderReader& reader) {
  constexpr std::uint32_t kMaxSide = 0x7fffffff;
  const auto width = reader.integer("width", 1, kMaxSide);
  if (!width) return tl::unexpected(width.error());
  const auto height = reader.integer("height", 1, kMaxSide);
  if (!height) return tl::unexpected(height.error());
  const std::size_t scale_offset = reader.position();
  const auto scale = reader.real("scale");
  if (!scale) return tl::unexpected(scale.error());
  if (*scale == 0) return bad_byte(scale_offset, "the scale is 0");
  if (auto end = reader.end_of_header(); !end) return tl::unexpected(end.error());
  return Header{*width, *height, *scale};
}

void append_float(std::vector<std::byte>& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<std::byte>(bits >> shift));
}

float load_float(std::span<const std::byte> bytes, std::size_t offset, bool little_endian) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto byte = std::to_integer<std::uint32_t>(bytes[offset + i]);
    bits |= byte << (little_endian ? 8 * i : 24 - 8 * i);
  }
  return std::bit_cast<float>(bits);
}

// Multiplying by one would keep every value, but not the payload of every NaN.
float scaled(float value, float scale) { return scale == 1.0f ? value : value * scale; }

}  // namespace

Expected<std::vector<std::byte>> encode_pfm(const Image& image, const ImageWriteOptions&) {
  const std::string header = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
  std::vector<std::byte> bytes;
  bytes.reserve(header.size() + image.pixels.size() * 12);
  for (const char c : header) bytes.push_back(static_cast<std::byte>(c));
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      for (int channel = 0; channel < 3; ++channel) append_float(bytes, image.at(x, y)[channel]);
    }
  }
  return bytes;
}

Expected<Image> decode_pfm(std::span<const std::byte> bytes, const ImageReadOptions& options) {
  HeaderReader reader(bytes, 2);
  const auto header = read_header(reader);
  if (!header) return tl::unexpected(header.error());
  const std::uint64_t channels = static_cast<char>(bytes[1]) == 'F' ? 3 : 1;
  const std::uint64_t raster = std::uint64_t{header->width} * header->height * channels * 4;
  auto image = allocate_image(header->width, header->height, reader.position() + raster,
                              bytes.size(), options);
  if (!image) return image;

  const auto scale = static_cast<float>(std::fabs(header->scale));
  std::size_t offset = reader.position();
  for (int y = image->height - 1; y >= 0; --y) {
    for (int x = 0; x < image->width; ++x) {
      Vec3f& pixel = image->at(x, y);
      for (int channel = 0; channel < 3; ++channel) {
        pixel[channel] = scaled(load_float(bytes, offset, header->scale < 0), scale);
        if (channels == 3) offset += 4;
      }
      if (channels == 1) offset += 4;
    }
  }
  return image;
}

}  // namespace dapple
