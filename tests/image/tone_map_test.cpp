#include "image/tone_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dapple {
namespace {

constexpr ToneMap kAll[] = {ToneMap::neutral, ToneMap::none, ToneMap::agx, ToneMap::aces};

TEST(ToneMaps, StayWithinTheDisplayAndRise) {
  for (const ToneMap curve : kAll) {
    float last = -1;
    for (float v = 0; v < 1e5f; v = v * 1.1f + 1e-4f) {
      const Vec3f c = tone_map(curve, {v, v, v});
      ASSERT_GE(c.y, last - 2e-3f) << v;  // the fitted polynomials wave a little
      ASSERT_LE(max_abs_component(c), 1.0f) << v;
      last = c.y;
    }
    EXPECT_GT(last, 0.95f);
  }
}

TEST(ToneMaps, GreysStayGrey) {
  for (const ToneMap curve : kAll) {
    for (const float v : {0.001f, 0.18f, 1.0f, 20.0f}) {
      const Vec3f c = tone_map(curve, {v, v, v});
      EXPECT_NEAR(c.x, c.y, 2e-3f);
      EXPECT_NEAR(c.z, c.y, 2e-3f);
    }
  }
}

// The promise of the neutral curve: a base colour c under light that makes its radiance
// 0.96 c + 0.04 (a dielectric's reflection) is shown as c, to 0.76.
TEST(ToneMaps, NeutralShowsBaseColoursAsTheyAre) {
  for (const Vec3f base : {Vec3f(0.5f, 0.2f, 0.1f), Vec3f(0.7f, 0.7f, 0.04f)}) {
    const Vec3f shown = tone_map(ToneMap::neutral, base + Vec3f(0.04f, 0.04f, 0.04f));
    EXPECT_LT(max_abs_component(shown - base), 1e-6f);
  }
}

TEST(ToneMaps, WhatIsNoColourIsBlack) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const ToneMap curve : kAll) {
    const Vec3f black = tone_map(curve, {0, 0, 0});
    EXPECT_EQ(tone_map(curve, {nan, -1, -infinity}), black);
    EXPECT_LT(max_abs_component(black), 2e-3f);
    EXPECT_GT(tone_map(curve, {infinity, infinity, infinity}).x, 0.95f);
  }
}

TEST(ToneMaps, ExposureCountsInStops) {
  Image image(1, 1);
  image.pixels[0] = {0.1f, 0.2f, 0.05f};
  apply_tone_map(image, ToneMap::none, 2);
  EXPECT_EQ(image.pixels[0], Vec3f(0.4f, 0.8f, 0.2f));
}

TEST(ToneMaps, AutomaticExposureBringsTheMeanToMiddleGrey) {
  Image image(3, 1);
  image.pixels = {{40, 40, 40}, {0, 0, 0}, {10, 10, 10}};  // geometric mean 20, black left out
  EXPECT_NEAR(automatic_exposure(image), std::log2(0.18 / 20), 1e-5);
  EXPECT_EQ(automatic_exposure(Image(4, 4)), 0);
}

TEST(ToneMaps, AlphaCoversMappedColours) {
  Image image(2, 1);
  const Vec3f colour(3, 1, 0.2f);
  image.pixels = {0.25f * colour, {1, 1, 1}};
  image.alpha = {0.25f, 0};
  apply_tone_map(image, ToneMap::aces, 0);
  EXPECT_LT(max_abs_component(image.pixels[0] - 0.25f * tone_map(ToneMap::aces, colour)), 1e-6f);
  EXPECT_EQ(image.pixels[1], Vec3f());
}

TEST(ToneMaps, UnknownNamesListTheKnown) {
  EXPECT_EQ(parse_tone_map("agx").value(), ToneMap::agx);
  const auto unknown = parse_tone_map("filmic");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message.find("neutral, none, agx, aces"), std::string::npos);
}

}  // namespace
}  // namespace dapple
