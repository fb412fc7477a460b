#include <fmt/format.h>

#include <algorithm>

#include "image/decoding.h"
#include "image/hdr.h"
#include "image/rgbe.h"
#include "parallel/parallel.h"

namespace dapple {
namespace {

struct Header {
  std::uint32_t width = 0, height = 0;
  bool bottom_up = false, right_to_left = false;
  double exposure = 1;  // the pixels are the radiance times this
};

Status read_variables(HeaderReader& reader, Header& header) {
  for (;;) {
    const std::size_t offset = reader.position();
    const auto line = reader.line();
    if (!line) return tl::unexpected(line.error());
    if (line->empty()) return {};
    if (line->starts_with("FORMAT=") && *line != "FORMAT=32-bit_rle_rgbe") {
      return bad_byte(offset, "the pixels are not RGBE");
    }
    if (line->starts_with("EXPOSURE=")) {
      HeaderReader value(std::as_bytes(std::span(*line)), 9);
      const auto exposure = value.real("exposure");
      if (!exposure || !(*exposure > 0)) return bad_byte(offset, "the exposure is not positive");
      header.exposure *= *exposure;
    }
  }
}

// "-Y 480 +X 640": rows from the top, columns from the left.
Status read_resolution(HeaderReader& reader, Header& header) {
  const std::size_t offset = reader.position();
  const auto line = reader.line();
  if (!line) return tl::unexpected(line.error());
  const auto axis = [&](std::size_t at, char name) {
    return at + 2 < line->size() && ((*line)[at] == '-' || (*line)[at] == '+') &&
           (*line)[at + 1] == name;
  };
  const std::size_t second = line->find(' ', 3) + 1;
  if (!axis(0, 'Y') || !axis(second, 'X')) {
    return bad_byte(offset, "the resolution is not of the form -Y HEIGHT +X WIDTH");
  }
  header.bottom_up = (*line)[0] == '+';
  header.right_to_left = (*line)[second] == '-';
  HeaderReader numbers(std::as_bytes(std::span(*line)), 2);
  const auto height = numbers.integer("height", 1, 0x7fffffff);
  HeaderReader last(std::as_bytes(std::span(*line)), second + 2);
  const auto width = last.integer("width", 1, 0x7fffffff);
  if (!height || !width) return bad_byte(offset, "the resolution is not two positive integers");
  header.height = *height;
  header.width = *width;
  return {};
}

// Scan lines one after the other, each in whichever of the three encodings it has.
class LineReader {
 public:
  LineReader(std::span<const std::byte> bytes, std::size_t position)
      : bytes_(bytes), position_(position) {}

  Status read(std::span<Rgbe> line) {
    return for_line(
        line.size(), [&] { return read_encoded<true>(line); }, line);
  }
  // Proves the line without keeping it; `scratch` is as wide.
  Status skip(std::span<Rgbe> scratch) {
    return for_line(
        scratch.size(), [&] { return read_encoded<false>(scratch); }, scratch);
  }
  std::size_t position() const { return position_; }

 private:
  template <class Encoded>
  Status for_line(std::size_t width, Encoded encoded_line, std::span<Rgbe> line) {
    if (bytes_.size() - position_ < 4) return ends_early();
    const bool encoded = is_run_width(width) && byte(0) == 2 && byte(1) == 2 && byte(2) < 128;
    return encoded ? encoded_line() : read_old(line);
  }
  std::uint8_t byte(std::size_t ahead) const {
    return std::to_integer<std::uint8_t>(bytes_[position_ + ahead]);
  }
  Status ends_early() const { return bad_byte(bytes_.size(), "the file ends within its pixels"); }

  template <bool keep>
  Status read_encoded(std::span<Rgbe> line) {
    if ((std::size_t{byte(2)} << 8 | byte(3)) != line.size()) {
      return bad_byte(position_ + 2, "a scan line has another width than the picture");
    }
    position_ += 4;
    for (std::size_t c = 0; c < 4; ++c) {
      if (auto read = read_component<keep>(line, c); !read) return read;
    }
    return {};
  }

  template <bool keep>
  Status read_component(std::span<Rgbe> line, std::size_t c) {
    std::size_t x = 0;
    while (x < line.size()) {
      if (bytes_.size() - position_ < 2) return ends_early();
      const bool run = byte(0) > 128;
      const std::size_t length = run ? byte(0) - 128u : byte(0);
      if (length == 0 || length > line.size() - x) {
        return bad_byte(position_, "a run leaves its scan line");
      }
      ++position_;
      if (!run && bytes_.size() - position_ < length) return ends_early();
      if constexpr (keep) {
        for (std::size_t i = 0; i < length; ++i) line[x + i][c] = byte(run ? 0 : i);
      }
      x += length;
      position_ += run ? 1 : length;
    }
    return {};
  }

  // Flat pixels, in which (1, 1, 1, n) repeats the pixel before n times; a repetition directly
  // after another counts 256 times as much.
  Status read_old(std::span<Rgbe> line) {
    std::size_t x = 0;
    int shift = 0;
    while (x < line.size()) {
      if (bytes_.size() - position_ < 4) return ends_early();
      const Rgbe pixel{byte(0), byte(1), byte(2), byte(3)};
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const std::uint64_t length = std::uint64_t{pixel[3]} << shift;
        if (x == 0 || length > line.size() - x) {
          return bad_byte(position_, "a run leaves its scan line");
        }
        std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(x), length, line[x - 1]);
        x += length;
        shift = std::min(shift + 8, 32);
      } else {
        line[x++] = pixel;
        shift = 0;
      }
      position_ += 4;
    }
    return {};
  }

  std::span<const std::byte> bytes_;
  std::size_t position_;
};

constexpr std::size_t kLinesAtOnce = 16;

// The least that a whole file can have: the old encoding repeats whole lines with a few bytes, but
// nothing sensible repeats more than 4096 pixels with one.
std::uint64_t least_bytes(const Header& header) {
  const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
  return std::max(std::uint64_t{header.height} * 4, pixels / 4096);
}

}  // namespace

Expected<Image> decode_hdr(std::span<const std::byte> bytes, const ImageReadOptions& options) {
  HeaderReader reader(bytes, 0);
  Header header;
  if (auto read = read_variables(reader, header); !read) return tl::unexpected(read.error());
  if (auto read = read_resolution(reader, header); !read) return tl::unexpected(read.error());
  auto image = allocate_image(header.width, header.height, reader.position() + least_bytes(header),
                              bytes.size(), options);
  if (!image) return image;

  // Where lines begin is known only after all before them; then they can be decoded at once.
  LineReader lines(bytes, reader.position());
  std::vector<Rgbe> scratch(header.width);
  std::vector<std::size_t> starts(header.height);
  for (std::size_t& start : starts) {
    start = lines.position();
    if (auto read = lines.skip(scratch); !read) return tl::unexpected(read.error());
  }
  const auto scale = static_cast<float>(1 / header.exposure);
  const std::size_t blocks = (starts.size() + kLinesAtOnce - 1) / kLinesAtOnce;
  parallel_for_dynamic(blocks, [&](std::size_t block) {
    std::vector<Rgbe> line(header.width);
    const std::size_t end = std::min((block + 1) * kLinesAtOnce, starts.size());
    for (std::size_t row = block * kLinesAtOnce; row < end; ++row) {
      (void)LineReader(bytes, starts[row]).read(line);
      if (header.right_to_left) std::reverse(line.begin(), line.end());
      const int y =
          header.bottom_up ? image->height - 1 - static_cast<int>(row) : static_cast<int>(row);
      for (int x = 0; x < image->width; ++x) {
        image->at(x, y) = scale * rgb_from_rgbe(line[static_cast<std::size_t>(x)]);
      }
    }
  });
  return image;
}

}  // namespace dapple
