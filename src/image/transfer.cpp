#include "image/transfer.h"

#include <cmath>

#include "math/functions.h"

namespace dapple {
namespace {

// x^(1/2.4) as (x^5)^(1/12): two square roots and a cube root, each the same on every machine.
float srgb_curve(float linear) {
  if (linear <= 0.0031308f) return 12.92f * linear;
  const double x = linear;
  const double twelfth_root = cube_root(std::sqrt(std::sqrt(x * x * x * x * x)));
  return static_cast<float>(1.055 * twelfth_root - 0.055);
}

}  // namespace

float encode_display(float linear, Transfer transfer) {
  if (!(linear > 0.0f)) return 0.0f;
  if (linear >= 1.0f) return 1.0f;
  return transfer == Transfer::gamma2 ? std::sqrt(linear) : srgb_curve(linear);
}

std::uint32_t encode_integer(float linear, Transfer transfer, std::uint32_t max) {
  const float display = encode_display(linear, transfer);
  return static_cast<std::uint32_t>(display * static_cast<float>(max) + 0.5f);
}

}  // namespace dapple
