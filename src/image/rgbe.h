// Radiance's pixel: three 8-bit mantissas that share one exponent [Ward91].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "math/vec3.h"

namespace dapple {

// Red, green, blue, exponent: the value is mantissa * 2^(exponent - 136), and 0 for exponent 0.
using Rgbe = std::array<std::uint8_t, 4>;

// Scan lines of other widths than these are never run-length encoded.
constexpr bool is_run_width(std::size_t width) { return width >= 8 && width <= 32767; }

// The nearest such values; at most 1/255 of the largest channel away. NaN and negative values
// become 0, too large ones 255 * 2^119, a pixel below 2^-128 black.
[[nodiscard]] Rgbe rgbe_from_rgb(const Vec3f& rgb);

[[nodiscard]] Vec3f rgb_from_rgbe(const Rgbe& rgbe);

}  // namespace dapple
