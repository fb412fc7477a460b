// How far two pictures are apart.
#pragma once

#include <cstdint>

#include "image/image.h"
#include "util/error.h"

namespace dapple {

// Over all pixels and the channels of colour, in linear light; of alpha apart, so that a picture
// without it, which is opaque, can be compared with one that has it. Equal values (two NaNs, or
// twice the same infinity, are equal) differ by 0; any other difference with a value that is not
// finite is infinite, and so are then rmse, mean_absolute, maximum and relative_mse.
struct ImageDifference {
  double rmse = 0;           // root of the mean squared difference
  double mean_absolute = 0;  // mean of |actual - expected|
  double relative_mse = 0;   // mean of (actual - expected)^2 / (expected^2 + 0.01) [RKZ12]
  Vec3d mean;                // mean of actual - expected in each channel, over its finite values
  double maximum = 0;        // greatest |actual - expected|, and the first pixel that has it
  int max_x = 0;
  int max_y = 0;
  int max_channel = 0;           // 0 red, 1 green, 2 blue
  std::uint64_t differing = 0;   // values that are not equal
  std::uint64_t non_finite = 0;  // values whose difference is infinite

  bool has_alpha = false;  // of either picture
  double alpha_rmse = 0;
  double alpha_maximum = 0;

  // Peak signal-to-noise ratio for a peak of 1, in decibels; infinite for equal pictures.
  double psnr() const;
};

// Pictures of different sizes are an error.
[[nodiscard]] Expected<ImageDifference> compare_images(const Image& actual, const Image& expected);

}  // namespace dapple
