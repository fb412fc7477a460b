#include "image/rgbe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/image/sample_images.h"

namespace dapple {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(Rgbe, KnownPixels) {
  EXPECT_EQ(rgbe_from_rgb({0, 0, 0}), (Rgbe{0, 0, 0, 0}));
  EXPECT_EQ(rgbe_from_rgb({1, 0.5f, 0.25f}), (Rgbe{128, 64, 32, 129}));
  EXPECT_EQ(rgbe_from_rgb({0.999f, 0, 1e-9f}), (Rgbe{128, 0, 0, 129})) << "rounds up to 1";
  EXPECT_EQ(rgbe_from_rgb({kNan, -1, 2}), (Rgbe{0, 0, 128, 130}));
  EXPECT_EQ(rgbe_from_rgb({kInfinity, 3e38f, 0}), (Rgbe{255, 255, 0, 255}));
  EXPECT_EQ(rgbe_from_rgb({0x1p-128f, 0, 0}), (Rgbe{128, 0, 0, 1}));
  EXPECT_EQ(rgbe_from_rgb({0x1p-130f, 0, 0}), (Rgbe{0, 0, 0, 0}));
  EXPECT_EQ(rgb_from_rgbe({128, 64, 32, 129}), Vec3f(1, 0.5f, 0.25f));
  EXPECT_EQ(rgb_from_rgbe({255, 255, 255, 0}), Vec3f(0, 0, 0));
}

TEST(Rgbe, TheNearestValueIsChosen) {
  const Image image = random_bits_image(1000, 200, 1);
  for (const Vec3f& bits : image.pixels) {
    const Vec3f rgb = {std::fabs(bits.x), std::fabs(bits.y), std::fabs(bits.z)};
    const float largest = std::max({rgb.x, rgb.y, rgb.z});
    if (!is_finite(rgb) || largest < 0x1p-127f || largest > 0x1p126f) continue;
    const Rgbe rgbe = rgbe_from_rgb(rgb);
    ASSERT_GE(std::max({rgbe[0], rgbe[1], rgbe[2]}), 128) << "the exponent is the smallest";
    const double half_step = std::ldexp(0.5, rgbe[3] - 136);
    const Vec3f back = rgb_from_rgbe(rgbe);
    for (int c = 0; c < 3; ++c) {
      ASSERT_LE(std::fabs(double{back[c]} - double{rgb[c]}), half_step);
    }
    ASSERT_LE(half_step, largest / 255.0);
    ASSERT_EQ(rgbe_from_rgb(back), rgbe);
  }
}

}  // namespace
}  // namespace dapple
