#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/functions.h"

namespace dapple {
namespace {

constexpr double kRelativeFloor = 0.01;

// Sums of one row: adding rows up keeps the rounding error of large pictures small.
struct Sums {
  double absolute = 0, squared = 0, relative = 0;
  Vec3d difference;

  void add(const Sums& other) {
    absolute += other.absolute;
    squared += other.squared;
    relative += other.relative;
    difference = difference + other.difference;
  }
};

bool same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

double difference_of(float actual, float expected) {
  if (same(actual, expected)) return 0;
  const double difference = double{actual} - double{expected};
  return std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
}

void add_value(Sums& sums, int channel, double difference, float expected) {
  if (difference == 0) return;
  const double squared = difference * difference;
  const double scale =
      std::isinf(squared) ? 1 : double{expected} * double{expected} + kRelativeFloor;
  sums.absolute += std::fabs(difference);
  sums.squared += squared;
  sums.relative += squared / scale;
  if (std::isfinite(difference)) sums.difference[channel] += difference;
}

void note(ImageDifference& result, double difference, int x, int y, int channel) {
  if (difference == 0) return;
  ++result.differing;
  if (std::isinf(difference)) ++result.non_finite;
  if (std::fabs(difference) <= result.maximum) return;
  result.maximum = std::fabs(difference);
  result.max_x = x;
  result.max_y = y;
  result.max_channel = channel;
}

float alpha_of(const Image& image, std::size_t pixel) {
  return image.alpha.empty() ? 1 : image.alpha[pixel];
}

void compare_alpha(const Image& actual, const Image& expected, ImageDifference& result) {
  result.has_alpha = !actual.alpha.empty() || !expected.alpha.empty();
  if (!result.has_alpha || actual.pixels.empty()) return;
  double squared = 0;
  for (int y = 0; y < actual.height; ++y) {
    double row = 0;
    for (int x = 0; x < actual.width; ++x) {
      const std::size_t pixel = actual.index(x, y);
      const double difference = difference_of(alpha_of(actual, pixel), alpha_of(expected, pixel));
      row += difference * difference;
      result.alpha_maximum = std::max(result.alpha_maximum, std::fabs(difference));
    }
    squared += row;
  }
  result.alpha_rmse = std::sqrt(squared / static_cast<double>(actual.pixels.size()));
}

}  // namespace

double ImageDifference::psnr() const {
  constexpr double kDecibels = 20 * 0.30102999566398119521;  // 20 log10 2
  if (rmse == 0) return std::numeric_limits<double>::infinity();
  return std::isfinite(rmse) ? -kDecibels * binary_log(rmse)
                             : -std::numeric_limits<double>::infinity();
}

Expected<ImageDifference> compare_images(const Image& actual, const Image& expected) {
  if (actual.width != expected.width || actual.height != expected.height) {
    return fail(Errc::bad_data, "",
                fmt::format("the pictures have different sizes: {} x {} and {} x {}", actual.width,
                            actual.height, expected.width, expected.height));
  }
  ImageDifference result;
  compare_alpha(actual, expected, result);
  Sums sums;
  for (int y = 0; y < actual.height; ++y) {
    Sums row;
    for (int x = 0; x < actual.width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        const float value = expected.at(x, y)[channel];
        const double difference = difference_of(actual.at(x, y)[channel], value);
        add_value(row, channel, difference, value);
        note(result, difference, x, y, channel);
      }
    }
    sums.add(row);
  }
  if (actual.pixels.empty()) return result;
  const auto pixels = static_cast<double>(actual.pixels.size());
  result.rmse = std::sqrt(sums.squared / (3 * pixels));
  result.mean_absolute = sums.absolute / (3 * pixels);
  result.relative_mse = sums.relative / (3 * pixels);
  result.mean = sums.difference / pixels;
  return result;
}

}  // namespace dapple
