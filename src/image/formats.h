// Image files: one table of formats, read by content and written by the ending of the name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "util/error.h"

namespace dapple {

// How linear values become the integers of a PPM or PNG file. EXR, PFM and HDR are always linear.
enum class Transfer {
  srgb,    // IEC 61966-2-1
  gamma2,  // square root, the classic programs' curve
};

struct ImageWriteOptions {
  Transfer transfer = Transfer::srgb;
  int png_bits = 8;        // 8 or 16
  bool exr_float = false;  // 32-bit float instead of half
};

struct ImageReadOptions {
  Transfer untagged = Transfer::srgb;     // curve of an integer file that does not name its own
  std::uint64_t max_pixels = 1ull << 28;  // a larger picture is refused
  bool alpha = false;                     // keep that of PNG and EXR files which have it
};

// What a pixel value that a format cannot hold becomes:
//            NaN   negative    too large    +infinity
//   PPM PNG  0     0           greatest     greatest
//   HDR      0     0           greatest     greatest
//   EXR half NaN   kept        +-65504      kept
//   EXR float and PFM keep every value as it is.

// The format is chosen by the ending of `path` (.png, .exr, .pfm, .hdr, .ppm, in any case); any
// other name is PPM. The file appears whole or not at all.
[[nodiscard]] Status write_image(const std::string& path, const Image& image,
                                 const ImageWriteOptions& options);

// The ending by which write_image chooses the format: ".png", ".exr", ".pfm", ".hdr", else ".ppm".
[[nodiscard]] std::string_view format_ending(std::string_view path);

// The picture in linear light: what write_image writes, and JPEG and WebP. The format is recognised
// by the file's first bytes, whatever its name. Alpha is left out unless asked for; a file without
// RGB channels gives grey.
[[nodiscard]] Expected<Image> read_image(const std::string& path,
                                         const ImageReadOptions& options = {});

// The same in memory. `name` is read only for its ending.
[[nodiscard]] Expected<std::vector<std::byte>> encode_image(std::string_view name,
                                                            const Image& image,
                                                            const ImageWriteOptions& options);
[[nodiscard]] Expected<Image> decode_image(std::span<const std::byte> bytes,
                                           const ImageReadOptions& options = {});

}  // namespace dapple
