#include "tests/statistics/picture_statistics.h"

#include <algorithm>
#include <cmath>

#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

// Rounding of single precision over a path: where samples have no noise, means differ by this.
constexpr double kRounding = 0x1p-20;

// The smallest of several p-values, corrected for their number (Sidak); exact for tiny ones.
double corrected(double smallest, double count) {
  return -std::expm1(count * std::log1p(-std::min(smallest, 1 - 1e-16)));
}

struct ChannelSums {
  double z_squared = 0;
  double difference = 0;
  double variance = 0;
  double rounding = 0;
};

}  // namespace

double PictureStatistics::mean(std::size_t pixel, std::size_t channel) const {
  return sums_[pixel][channel] / samples_;
}

double PictureStatistics::variance(std::size_t pixel, std::size_t channel) const {
  const double m = mean(pixel, channel);
  return std::max(0.0, squares_[pixel][channel] / samples_ - m * m) / (samples_ - 1);
}

double PictureAgreement::p_value() const {
  return corrected(std::min({worst_pixel, all_pixels, whole}), 3);
}

std::ostream& operator<<(std::ostream& out, const PictureAgreement& a) {
  return out << "p-values: worst pixel " << a.worst_pixel << " (x " << a.worst_x << ", y "
             << a.worst_y << ", channel " << a.worst_channel << "), all pixels " << a.all_pixels
             << ", whole " << a.whole;
}

PictureAgreement compare_pictures(const PictureStatistics& a, const PictureStatistics& b) {
  PictureAgreement result;
  std::array<ChannelSums, 3> channels;
  double worst_z = 0;
  for (std::size_t pixel = 0; pixel < a.pixel_count(); ++pixel) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double difference = a.mean(pixel, c) - b.mean(pixel, c);
      const double variance = a.variance(pixel, c) + b.variance(pixel, c);
      const double z = difference / std::sqrt(variance + kRounding * kRounding);
      channels[c].z_squared += z * z;
      channels[c].difference += difference;
      channels[c].variance += variance;
      channels[c].rounding += kRounding;
      if (std::fabs(z) > worst_z) {
        worst_z = std::fabs(z);
        result.worst_x = static_cast<int>(pixel) % a.width();
        result.worst_y = static_cast<int>(pixel) / a.width();
        result.worst_channel = c;
      }
    }
  }
  const auto pixels = static_cast<double>(a.pixel_count());
  result.worst_pixel = corrected(normal_two_sided_tail(worst_z), 3 * pixels);
  for (const ChannelSums& sums : channels) {
    const double sigma = std::sqrt(sums.variance + sums.rounding * sums.rounding);
    result.all_pixels = std::min(result.all_pixels, chi_squared_tail(sums.z_squared, pixels));
    result.whole = std::min(result.whole, normal_two_sided_tail(sums.difference / sigma));
  }
  result.all_pixels = corrected(result.all_pixels, 3);
  result.whole = corrected(result.whole, 3);
  return result;
}

}  // namespace dapple::test
