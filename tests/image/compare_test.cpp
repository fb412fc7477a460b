#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/image/sample_images.h"

namespace dapple {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

ImageDifference compare(const Image& actual, const Image& expected) {
  return compare_images(actual, expected).value();
}

TEST(CompareImages, EqualPicturesDoNotDiffer) {
  const Image image = random_bits_image(30, 20, 3);  // with NaNs and infinities
  const ImageDifference difference = compare(image, image);
  EXPECT_EQ(difference.rmse, 0);
  EXPECT_EQ(difference.mean_absolute, 0);
  EXPECT_EQ(difference.relative_mse, 0);
  EXPECT_EQ(difference.mean, Vec3d());
  EXPECT_EQ(difference.maximum, 0);
  EXPECT_EQ(difference.differing, 0u);
  EXPECT_EQ(difference.psnr(), HUGE_VAL);
}

TEST(CompareImages, OneDifferentValueIsFound) {
  const Image expected = constant_image(10, 7, {0.5f, 0.5f, 0.5f});
  Image actual = expected;
  actual.at(6, 4).y = 0.25f;
  const ImageDifference difference = compare(actual, expected);
  EXPECT_DOUBLE_EQ(difference.rmse, 0.25 / std::sqrt(210));
  EXPECT_DOUBLE_EQ(difference.mean_absolute, 0.25 / 210);
  EXPECT_DOUBLE_EQ(difference.relative_mse, 0.0625 / 0.26 / 210);
  EXPECT_EQ(difference.mean, Vec3d(0, -0.25 / 70, 0));
  EXPECT_EQ(difference.maximum, 0.25);
  EXPECT_EQ(difference.max_x, 6);
  EXPECT_EQ(difference.max_y, 4);
  EXPECT_EQ(difference.max_channel, 1);
  EXPECT_EQ(difference.differing, 1u);
  EXPECT_NEAR(difference.psnr(), -20 * std::log10(difference.rmse), 1e-12);
}

TEST(CompareImages, MatchesTheDefinitionsOnRandomPictures) {
  const Image actual = random_image(61, 43, 1);
  const Image expected = random_image(61, 43, 2);
  double absolute = 0, squared = 0, maximum = 0;
  Vec3d sum;
  for (std::size_t i = 0; i < actual.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double d = double{actual.pixels[i][c]} - double{expected.pixels[i][c]};
      absolute += std::fabs(d);
      squared += d * d;
      sum[c] += d;
      maximum = std::fmax(maximum, std::fabs(d));
    }
  }
  const ImageDifference difference = compare(actual, expected);
  EXPECT_NEAR(difference.mean_absolute, absolute / (61 * 43 * 3), 1e-14);
  EXPECT_NEAR(difference.rmse, std::sqrt(squared / (61 * 43 * 3)), 1e-14);
  EXPECT_EQ(difference.maximum, maximum);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(difference.mean[c], sum[c] / (61 * 43), 1e-14);
  // Exchanging the pictures turns the sign and nothing else of these.
  const ImageDifference other = compare(expected, actual);
  EXPECT_EQ(other.rmse, difference.rmse);
  EXPECT_EQ(other.mean, -difference.mean);
  EXPECT_EQ(other.max_x, difference.max_x);
  EXPECT_EQ(other.max_y, difference.max_y);
}

TEST(CompareImages, NonFiniteValuesAreInfinitelyFarFromOthers) {
  const Image zero = constant_image(4, 4, {});
  for (const float value : {kNan, kInfinity, -kInfinity}) {
    Image odd = zero;
    odd.at(1, 2).z = value;
    odd.at(3, 3).x = 1;
    for (const ImageDifference& difference : {compare(odd, zero), compare(zero, odd)}) {
      EXPECT_EQ(difference.rmse, HUGE_VAL);
      EXPECT_EQ(difference.mean_absolute, HUGE_VAL);
      EXPECT_EQ(difference.relative_mse, HUGE_VAL);
      EXPECT_EQ(difference.maximum, HUGE_VAL);
      EXPECT_EQ(difference.max_x, 1);
      EXPECT_EQ(difference.max_y, 2);
      EXPECT_EQ(difference.max_channel, 2);
      EXPECT_EQ(difference.non_finite, 1u);
      EXPECT_EQ(difference.differing, 2u);
      EXPECT_EQ(std::fabs(difference.mean.x), 1 / 16.0);
      EXPECT_EQ(difference.mean.z, 0) << "finite values only";
      EXPECT_EQ(difference.psnr(), -HUGE_VAL);
    }
  }
}

TEST(CompareImages, DifferentSizesAreAnError) {
  const auto difference = compare_images(Image(3, 2), Image(2, 3));
  ASSERT_FALSE(difference);
  EXPECT_EQ(difference.error().code, Errc::bad_data);
  EXPECT_EQ(difference.error().message, "the pictures have different sizes: 3 x 2 and 2 x 3");
}

}  // namespace
}  // namespace dapple
