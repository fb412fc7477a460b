#include "image/transfer.h"

#include <cmath>

#include "math/functions.h"

namespace dapple {
namespace {

// x^(1/2.4) as (x^5)^(1/12): two square roots and a cube root, each the same on every machine.
double srgb_from_linear(double linear) {
  if (linear <= 0.0031308) return 12.92 * linear;
  const double x = linear;
  return 1.055 * cube_root(std::sqrt(std::sqrt(x * x * x * x * x))) - 0.055;
}

double linear_from_srgb(double display) {
  return display <= 0.04045 ? display / 12.92 : power((display + 0.055) / 1.055, 2.4);
}

template <class Decode>
std::vector<float> make_table(std::uint32_t max, Decode decode) {
  std::vector<float> table(max + 1);
  for (std::uint32_t i = 0; i <= max; ++i) {
    table[i] = static_cast<float>(decode(static_cast<double>(i) / max));
  }
  return table;
}

}  // namespace

double encode_display(float linear, Transfer transfer) {
  if (!(linear > 0.0f)) return 0.0;
  if (linear >= 1.0f) return 1.0;
  const double x = linear;
  return transfer == Transfer::gamma2 ? std::sqrt(x) : srgb_from_linear(x);
}

std::uint32_t encode_integer(float linear, Transfer transfer, std::uint32_t max) {
  return static_cast<std::uint32_t>(encode_display(linear, transfer) * max + 0.5);
}

double decode_display(double display, Transfer transfer) {
  return transfer == Transfer::gamma2 ? display * display : linear_from_srgb(display);
}

std::vector<float> decode_table(std::uint32_t max, Transfer transfer) {
  return make_table(max, [=](double display) { return decode_display(display, transfer); });
}

std::vector<float> decode_table(std::uint32_t max, double gamma) {
  return make_table(max, [=](double display) { return power(display, 1 / gamma); });
}

}  // namespace dapple
