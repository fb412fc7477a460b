#include "image/decoding.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace dapple {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

tl::unexpected<Error> bad_byte(std::size_t offset, std::string message) {
  return fail(Errc::bad_data, fmt::format("byte {}", offset), std::move(message));
}

Status check_picture_size(std::uint64_t width, std::uint64_t height, std::uint64_t max_pixels) {
  constexpr std::uint64_t kMaxSide = 0x7fffffff;
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide ||
      width * height > max_pixels) {
    return fail(Errc::bad_data, "",
                fmt::format("{} x {} pixels are not a picture of 1 to {} pixels", width, height,
                            max_pixels));
  }
  return {};
}

Expected<Image> allocate_image(std::uint64_t width, std::uint64_t height,
                               std::uint64_t bytes_needed, std::uint64_t bytes_there,
                               const ImageReadOptions& options) {
  if (auto allowed = check_picture_size(width, height, options.max_pixels); !allowed) {
    return tl::unexpected(allowed.error());
  }
  if (bytes_there < bytes_needed) {
    return bad_byte(bytes_there, fmt::format("the file ends early: {} x {} pixels need {} bytes",
                                             width, height, bytes_needed));
  }
  return Image(static_cast<int>(width), static_cast<int>(height));
}

void HeaderReader::skip_space_and_comments() {
  while (!at_end() && (is_space(peek()) || peek() == '#')) {
    if (peek() == '#') {
      while (!at_end() && peek() != '\n') ++position_;
    } else {
      ++position_;
    }
  }
}

std::string_view HeaderReader::word() {
  skip_space_and_comments();
  const std::size_t start = position_;
  while (!at_end() && !is_space(peek())) ++position_;
  return {reinterpret_cast<const char*>(bytes_.data()) + start, position_ - start};
}

Expected<std::uint32_t> HeaderReader::integer(std::string_view what, std::uint32_t low,
                                              std::uint32_t high) {
  const std::string_view text = word();
  const std::size_t start = position_ - text.size();
  if (text.empty()) return bad_byte(start, fmt::format("the file ends before the {}", what));
  std::uint32_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || value < low || value > high) {
    return bad_byte(start, fmt::format("the {} is not an integer from {} to {}", what, low, high));
  }
  return value;
}

Expected<double> HeaderReader::real(std::string_view what) {
  const std::string_view text = word();
  const std::size_t start = position_ - text.size();
  if (text.empty()) return bad_byte(start, fmt::format("the file ends before the {}", what));
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !std::isfinite(value)) {
    return bad_byte(start, fmt::format("the {} is not a number", what));
  }
  return value;
}

Status HeaderReader::end_of_header() {
  if (at_end()) return bad_byte(position_, "the file ends after its header");
  if (!is_space(peek())) return bad_byte(position_, "no white space after the header");
  ++position_;
  return {};
}

Expected<std::string_view> HeaderReader::line() {
  const std::size_t start = position_;
  while (!at_end() && peek() != '\n') ++position_;
  if (at_end()) return bad_byte(position_, "the file ends within its header");
  ++position_;
  return std::string_view(reinterpret_cast<const char*>(bytes_.data()) + start,
                          position_ - 1 - start);
}

}  // namespace dapple
