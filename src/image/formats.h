// One table of image formats: what a file name's ending selects.
#pragma once

#include <string>
#include <string_view>

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

// The format is chosen by the ending of `path` (.png, .exr, .pfm, .hdr, .ppm, in any case); any
// other name is PPM. The file appears whole or not at all.
[[nodiscard]] Status write_image(const std::string& path, const Image& image,
                                 const ImageWriteOptions& options);

}  // namespace dapple
