// From linear values to the integers of display files.
#pragma once

#include <cstdint>

#include "image/formats.h"

namespace dapple {

// The display value in [0, 1] of a linear one; below 0 and NaN give 0, above 1 gives 1.
[[nodiscard]] float encode_display(float linear, Transfer transfer);

// The same as the nearest integer in [0, max].
[[nodiscard]] std::uint32_t encode_integer(float linear, Transfer transfer, std::uint32_t max);

}  // namespace dapple
