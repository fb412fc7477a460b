#include "image/rgbe.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dapple {
namespace {

constexpr int kExponentBias = 128;
constexpr int kMantissaBits = 8;
constexpr float kLargest = 255 * 0x1p119f;

float representable(float value) { return value > 0.0f ? std::min(value, kLargest) : 0.0f; }

}  // namespace

Rgbe rgbe_from_rgb(const Vec3f& rgb) {
  const float channels[3] = {representable(rgb.x), representable(rgb.y), representable(rgb.z)};
  const float largest = std::max({channels[0], channels[1], channels[2]});
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest is in [2^(exponent-1), 2^exponent)
  const auto mantissa = [&](float value) {
    return static_cast<int>(std::ldexp(double{value}, kMantissaBits - exponent) + 0.5);
  };
  if (mantissa(largest) == 1 << kMantissaBits) ++exponent;
  if (largest == 0.0f || exponent + kExponentBias < 1) return {0, 0, 0, 0};
  const auto byte = [&](float value) { return static_cast<std::uint8_t>(mantissa(value)); };
  return {byte(channels[0]), byte(channels[1]), byte(channels[2]),
          static_cast<std::uint8_t>(exponent + kExponentBias)};
}

Vec3f rgb_from_rgbe(const Rgbe& rgbe) {
  if (rgbe[3] == 0) return {};
  const int exponent = rgbe[3] - kExponentBias - kMantissaBits;
  // Normal numbers are put together from their bits; std::ldexp takes ten times as long.
  const float step = exponent >= -126
                         ? std::bit_cast<float>(static_cast<std::uint32_t>(exponent + 127) << 23)
                         : std::ldexp(1.0f, exponent);
  return {step * static_cast<float>(rgbe[0]), step * static_cast<float>(rgbe[1]),
          step * static_cast<float>(rgbe[2])};
}

}  // namespace dapple
