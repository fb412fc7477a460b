// What the readers of all formats share. The place of their errors is the byte offset; the caller
// adds the file's name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "image/formats.h"

namespace dapple {

[[nodiscard]] tl::unexpected<Error> bad_byte(std::size_t offset, std::string message);

// Fails for a picture without pixels or with more than `max_pixels`.
[[nodiscard]] Status check_picture_size(std::uint64_t width, std::uint64_t height,
                                        std::uint64_t max_pixels);

// A black picture, once the size is known to be allowed and `bytes_needed`, the least that a whole
// file of this size can have, is there. So memory is never taken on the word of a short file.
[[nodiscard]] Expected<Image> allocate_image(std::uint64_t width, std::uint64_t height,
                                             std::uint64_t bytes_needed, std::uint64_t bytes_there,
                                             const ImageReadOptions& options);

// Reads the text at the start of a PPM, PFM or HDR file.
class HeaderReader {
 public:
  HeaderReader(std::span<const std::byte> bytes, std::size_t position)
      : bytes_(bytes), position_(position) {}

  std::size_t position() const { return position_; }
  std::span<const std::byte> rest() const { return bytes_.subspan(position_); }

  // A decimal integer in [low, high]; white space and '#' comments before it are skipped.
  // `what` names it in the error.
  [[nodiscard]] Expected<std::uint32_t> integer(std::string_view what, std::uint32_t low,
                                                std::uint32_t high);
  [[nodiscard]] Expected<double> real(std::string_view what);
  // The one white-space character between the header and the pixels.
  [[nodiscard]] Status end_of_header();
  // Up to the next line feed, which is read too.
  [[nodiscard]] Expected<std::string_view> line();

 private:
  char peek() const { return static_cast<char>(bytes_[position_]); }
  bool at_end() const { return position_ == bytes_.size(); }
  void skip_space_and_comments();
  std::string_view word();

  std::span<const std::byte> bytes_;
  std::size_t position_;
};

}  // namespace dapple
