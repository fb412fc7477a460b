// Binary PPM (P6), 8 bits.
#pragma once

#include <cstddef>
#include <vector>

#include "image/formats.h"

namespace dapple {

[[nodiscard]] std::vector<std::byte> encode_ppm(const Image& image, Transfer transfer);

}  // namespace dapple
