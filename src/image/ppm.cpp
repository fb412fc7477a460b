#include "image/ppm.h"

#include <fmt/format.h>

#include "image/decoding.h"
#include "image/transfer.h"

namespace dapple {
namespace {

struct Header {
  bool text = false;
  bool grey = false;
  std::uint32_t width = 0, height = 0, max = 0;

  std::uint64_t sample_count() const { return std::uint64_t{width} * height * (grey ? 1 : 3); }
  std::uint64_t sample_bytes() const { return max > 255 ? 2 : 1; }
  // Text has at least a digit and a space for each sample but the last.
  std::uint64_t raster_bytes() const {
    return text ? sample_count() * 2 - 1 : sample_count() * sample_bytes();
  }
};

Expected<Header> read_header(HeaderReader& reader, char kind) {
  constexpr std::uint32_t kMaxSide = 0x7fffffff;
  const auto width = reader.integer("width", 1, kMaxSide);
  if (!width) return tl::unexpected(width.error());
  const auto height = reader.integer("height", 1, kMaxSide);
  if (!height) return tl::unexpected(height.error());
  const auto max = reader.integer("maximum value", 1, 65535);
  if (!max) return tl::unexpected(max.error());
  if (auto end = reader.end_of_header(); !end) return tl::unexpected(end.error());
  return Header{kind == '2' || kind == '3', kind == '2' || kind == '5', *width, *height, *max};
}

// Samples as big-endian integers; the size of the raster has been checked.
class BinarySamples {
 public:
  BinarySamples(const HeaderReader& reader, const Header& header)
      : rest_(reader.rest()), start_(reader.position()), header_(header) {}

  Expected<std::uint32_t> next() {
    auto sample = std::to_integer<std::uint32_t>(rest_[position_++]);
    if (header_.sample_bytes() == 2) {
      sample = sample << 8 | std::to_integer<std::uint32_t>(rest_[position_++]);
    }
    if (sample <= header_.max) return sample;
    return bad_byte(start_ + position_ - header_.sample_bytes(),
                    fmt::format("a sample is {}, above the maximum {}", sample, header_.max));
  }

 private:
  std::span<const std::byte> rest_;
  std::size_t start_;
  std::size_t position_ = 0;
  const Header& header_;
};

class TextSamples {
 public:
  TextSamples(HeaderReader& reader, const Header& header) : reader_(reader), header_(header) {}

  Expected<std::uint32_t> next() { return reader_.integer("sample", 0, header_.max); }

 private:
  HeaderReader& reader_;
  const Header& header_;
};

template <class Samples>
Status fill(Image& image, bool grey, const std::vector<float>& table, Samples samples) {
  for (Vec3f& pixel : image.pixels) {
    for (int channel = 0; channel < (grey ? 1 : 3); ++channel) {
      const Expected<std::uint32_t> sample = samples.next();
      if (!sample) return tl::unexpected(sample.error());
      pixel[channel] = table[*sample];
    }
    if (grey) pixel = {pixel.x, pixel.x, pixel.x};
  }
  return {};
}

}  // namespace

Expected<std::vector<std::byte>> encode_ppm(const Image& image, const ImageWriteOptions& options) {
  const std::string header = fmt::format("P6\n{} {}\n255\n", image.width, image.height);
  std::vector<std::byte> bytes;
  bytes.reserve(header.size() + image.pixels.size() * 3);
  for (const char c : header) bytes.push_back(static_cast<std::byte>(c));
  for (const Vec3f& pixel : image.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      bytes.push_back(
          static_cast<std::byte>(encode_integer(pixel[channel], options.transfer, 255)));
    }
  }
  return bytes;
}

Expected<Image> decode_ppm(std::span<const std::byte> bytes, const ImageReadOptions& options) {
  HeaderReader reader(bytes, 2);
  const auto header = read_header(reader, static_cast<char>(bytes[1]));
  if (!header) return tl::unexpected(header.error());
  auto image = allocate_image(header->width, header->height,
                              reader.position() + header->raster_bytes(), bytes.size(), options);
  if (!image) return image;
  const std::vector<float> table = decode_table(header->max, options.untagged);
  const Status filled = header->text
                            ? fill(*image, header->grey, table, TextSamples(reader, *header))
                            : fill(*image, header->grey, table, BinarySamples(reader, *header));
  if (!filled) return tl::unexpected(filled.error());
  return image;
}

}  // namespace dapple
