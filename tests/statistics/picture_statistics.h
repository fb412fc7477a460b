// Pictures judged by statistics: two renderings agree if their difference is what the noise of
// their samples allows, in every pixel, in all pixels together, and on the whole.
#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace dapple::test {

using Channels = std::array<double, 3>;

// Mean and variance of the samples of each pixel, top row first.
class PictureStatistics {
 public:
  PictureStatistics(int width, int height)
      : width_(width),
        height_(height),
        sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
        squares_(sums_.size()) {}

  void add(std::size_t pixel, const Channels& sample) {
    for (std::size_t c = 0; c < 3; ++c) {
      sums_[pixel][c] += sample[c];
      squares_[pixel][c] += sample[c] * sample[c];
    }
  }
  // Samples that every pixel has been given.
  void set_sample_count(int samples) { samples_ = samples; }

  int width() const { return width_; }
  int height() const { return height_; }
  int sample_count() const { return samples_; }
  std::size_t pixel_count() const { return sums_.size(); }
  double mean(std::size_t pixel, std::size_t channel) const;
  // Estimated variance of the mean.
  double variance(std::size_t pixel, std::size_t channel) const;

 private:
  int width_;
  int height_;
  int samples_ = 0;
  std::vector<Channels> sums_;
  std::vector<Channels> squares_;
};

// p-values of the hypothesis that two pictures have the same expectation, each corrected for the
// number of comparisons behind it.
struct PictureAgreement {
  double worst_pixel = 1;  // the pixel and channel with the largest |z|
  double all_pixels = 1;   // chi-squared: the sum of z^2 of each channel
  double whole = 1;        // z-test of each channel's mean over the picture
  int worst_x = 0, worst_y = 0;
  std::size_t worst_channel = 0;

  double p_value() const;  // of the three together
};
std::ostream& operator<<(std::ostream& out, const PictureAgreement& agreement);

// Both pictures need the same size and, so that skewed noise cancels in the difference, the same
// number of samples.
[[nodiscard]] PictureAgreement compare_pictures(const PictureStatistics& a,
                                                const PictureStatistics& b);

}  // namespace dapple::test
