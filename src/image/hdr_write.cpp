#include <fmt/format.h>

#include "image/hdr.h"
#include "image/rgbe.h"

namespace dapple {
namespace {

constexpr std::size_t kMinRun = 4;
constexpr std::size_t kMaxRun = 127;
constexpr std::size_t kMaxLiteral = 128;

using Bytes = std::vector<std::byte>;

std::size_t run_length(std::span<const std::uint8_t> values, std::size_t start) {
  std::size_t end = start + 1;
  while (end < values.size() && end - start < kMaxRun && values[end] == values[start]) ++end;
  return end - start;
}

// Runs of at least kMinRun equal values as (128 + length, value), all else as (length, values...).
void append_component(Bytes& bytes, std::span<const std::uint8_t> values) {
  std::size_t position = 0;
  while (position < values.size()) {
    std::size_t literal_end = position;
    std::size_t run = 0;
    while (literal_end < values.size() && literal_end - position < kMaxLiteral) {
      run = run_length(values, literal_end);
      if (run >= kMinRun) break;
      ++literal_end;
    }
    if (literal_end > position) {
      bytes.push_back(static_cast<std::byte>(literal_end - position));
      for (; position < literal_end; ++position) {
        bytes.push_back(static_cast<std::byte>(values[position]));
      }
    } else {
      bytes.push_back(static_cast<std::byte>(128 + run));
      bytes.push_back(static_cast<std::byte>(values[position]));
      position += run;
    }
  }
}

void append_line(Bytes& bytes, std::span<const Rgbe> line, std::vector<std::uint8_t>& component) {
  if (!is_run_width(line.size())) {
    for (const Rgbe& pixel : line) {
      for (const std::uint8_t value : pixel) bytes.push_back(static_cast<std::byte>(value));
    }
    return;
  }
  for (const std::size_t value : {std::size_t{2}, std::size_t{2}, line.size() >> 8, line.size()}) {
    bytes.push_back(static_cast<std::byte>(value));
  }
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t x = 0; x < line.size(); ++x) component[x] = line[x][c];
    append_component(bytes, component);
  }
}

}  // namespace

Expected<Bytes> encode_hdr(const Image& image, const ImageWriteOptions&) {
  const std::string header =
      fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height, image.width);
  Bytes bytes;
  for (const char c : header) bytes.push_back(static_cast<std::byte>(c));
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<Rgbe> line(width);
  std::vector<std::uint8_t> component(width);
  for (std::size_t start = 0; start < image.pixels.size(); start += width) {
    for (std::size_t x = 0; x < width; ++x) line[x] = rgbe_from_rgb(image.pixels[start + x]);
    append_line(bytes, line, component);
  }
  return bytes;
}

}  // namespace dapple
