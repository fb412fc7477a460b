#include "render/pixel_filter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "math/functions.h"

namespace dapple {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"box", "gaussian", "blackman-harris"};

constexpr int kSteps = 4096;        // of the inverse distribution
constexpr int kCells = 4 * kSteps;  // of the density it is made from

struct Shape {
  double half_width;                   // pixels
  double (*density)(double position);  // position in (-1, 1), not normalised
};

double gaussian(double x) {
  const double pixels = 1.2 * x;
  return binary_exp(-1.4426950408889634 * pixels * pixels / (2 * 0.4 * 0.4));
}

double blackman_harris(double x) {
  const double turns = (x + 1) / 2;
  const auto cosine = [&](int k) { return sin_cos_turns(k * turns).cos; };
  return 0.35875 - 0.48829 * cosine(1) + 0.14128 * cosine(2) - 0.01168 * cosine(3);
}

std::vector<double> distribution(const Shape& shape) {
  std::vector<double> sums(kCells + 1, 0.0);
  for (std::size_t i = 0; i < kCells; ++i) {
    const double middle = (static_cast<double>(i) + 0.5) / kCells * 2 - 1;
    sums[i + 1] = sums[i] + shape.density(middle);
  }
  for (double& sum : sums) sum /= sums[kCells];
  return sums;
}

std::vector<float> invert(const Shape& shape) {
  const std::vector<double> sums = distribution(shape);
  std::vector<float> places(kSteps + 1);
  std::size_t cell = 0;
  for (std::size_t i = 0; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps;
    while (cell + 1 < kCells && sums[cell + 1] < u) ++cell;
    const double inside = (u - sums[cell]) / (sums[cell + 1] - sums[cell]);
    const double position = (static_cast<double>(cell) + inside) / kCells * 2 - 1;
    places[i] = static_cast<float>(0.5 + shape.half_width * position);
  }
  return places;
}

}  // namespace

Expected<FilterKind> parse_filter(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<FilterKind>(i);
  }
  return fail(Errc::usage, std::string(name),
              fmt::format("unknown pixel filter; there are {}", fmt::join(kNames, ", ")));
}

PixelFilter::PixelFilter(FilterKind kind) {
  if (kind == FilterKind::gaussian) places_ = invert({1.2, gaussian});
  if (kind == FilterKind::blackman_harris) places_ = invert({1.5, blackman_harris});
}

FilterView PixelFilter::view() const {
  return {places_.empty() ? nullptr : places_.data(), kSteps};
}

float PixelFilter::place(float u) const {
  if (places_.empty()) return u;
  const float x = u * kSteps;
  const auto step = static_cast<std::size_t>(x);
  const float rest = x - static_cast<float>(step);
  return (1.0f - rest) * places_[step] + rest * places_[step + 1];
}

}  // namespace dapple
