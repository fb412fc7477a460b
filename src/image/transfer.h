// Between linear values and the integers of display files.
#pragma once

#include <cstdint>
#include <vector>

#include "image/formats.h"

namespace dapple {

// The display value in [0, 1] of a linear one; below 0 and NaN give 0, above 1 gives 1.
[[nodiscard]] double encode_display(float linear, Transfer transfer);

// The same as the nearest integer in [0, max], max <= 65535. For sRGB and gamma 2 this is the
// nearest integer to the exact curve, whatever the float.
[[nodiscard]] std::uint32_t encode_integer(float linear, Transfer transfer, std::uint32_t max);

// The linear value of a display value in [0, 1]; relative error below 1e-14.
[[nodiscard]] double decode_display(double display, Transfer transfer);

// The linear values of the integers 0 to max.
[[nodiscard]] std::vector<float> decode_table(std::uint32_t max, Transfer transfer);
// The same for a file whose display value is linear^gamma.
[[nodiscard]] std::vector<float> decode_table(std::uint32_t max, double gamma);

}  // namespace dapple
