#include "tests/statistics/picture_statistics.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

constexpr int kWidth = 16, kHeight = 12, kSamples = 400;

// Skewed noise: most samples are dark, few are bright, as in a rendered picture. `bias` shifts
// every pixel, `wrong_pixel` only one.
PictureStatistics noise(std::uint64_t seed, double bias = 0, double wrong_pixel = 0) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  PictureStatistics picture(kWidth, kHeight);
  for (std::size_t pixel = 0; pixel < picture.pixel_count(); ++pixel) {
    const double brightness = static_cast<double>(1 + pixel % 17) / 19;
    const double shift = bias + (pixel == 100 ? wrong_pixel : 0);
    for (int s = 0; s < kSamples; ++s) {
      const double rare = uniform(random) < brightness ? 1 : 0;
      picture.add(pixel, {rare + shift, 1, 0.2 * uniform(random) + shift});
    }
  }
  picture.set_sample_count(kSamples);
  return picture;
}

TEST(PictureStatistics, MeanAndVarianceOfThePixel) {
  PictureStatistics picture(1, 1);
  for (const double x : {1.0, 2.0, 6.0}) picture.add(0, {x, 1, 0});
  picture.set_sample_count(3);
  EXPECT_DOUBLE_EQ(picture.mean(0, 0), 3);
  EXPECT_DOUBLE_EQ(picture.variance(0, 0), 7.0 / 3);  // (4 + 1 + 9) / 2, over three samples
  EXPECT_DOUBLE_EQ(picture.variance(0, 1), 0);
}

TEST(PictureStatistics, EqualExpectationsAreRarelyRejected) {
  int rejected = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    rejected += compare_pictures(noise(2 * seed), noise(2 * seed + 1)).p_value() < 0.01;
  }
  EXPECT_LE(rejected, 8);  // expected: at most 2
}

TEST(PictureStatistics, ASmallBiasEverywhereIsFound) {
  const PictureAgreement agreement = compare_pictures(noise(1), noise(2, 0.002));
  EXPECT_LT(agreement.whole, kSignificance) << agreement;
  EXPECT_GT(agreement.worst_pixel, kSignificance) << "needs all pixels together";
}

TEST(PictureStatistics, OneWrongPixelIsFound) {
  const PictureAgreement agreement = compare_pictures(noise(1), noise(2, 0, 0.02));
  EXPECT_LT(agreement.worst_pixel, kSignificance) << agreement;
  EXPECT_EQ(agreement.worst_y * kWidth + agreement.worst_x, 100);
}

}  // namespace
}  // namespace dapple::test
