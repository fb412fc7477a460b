#include "math/functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dapple {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(Functions, SineAndCosineMatchTheMathematicalLibrary) {
  for (int i = -40'000; i <= 40'000; ++i) {
    const double turns = i / 10'007.0;
    const auto exact = sin_cos_turns(turns);
    EXPECT_NEAR(exact.sin, std::sin(2 * kPi * turns), 4e-15);
    EXPECT_NEAR(exact.cos, std::cos(2 * kPi * turns), 4e-15);
    const auto single = sin_cos_turns(static_cast<float>(turns));
    const double rounded = static_cast<float>(turns);
    EXPECT_NEAR(single.sin, std::sin(2 * kPi * rounded), 1.2e-7);
    EXPECT_NEAR(single.cos, std::cos(2 * kPi * rounded), 1.2e-7);
  }
}

TEST(Functions, SineAndCosineOfAnyNumberOfTurnsAreOnTheCircle) {
  constexpr double kHuge = 1e78, kInfinity = std::numeric_limits<double>::infinity();
  for (const double turns : {kHuge, -kHuge, 3e18, 1e300, 2097152.25, kInfinity, -kInfinity,
                             std::numeric_limits<double>::quiet_NaN()}) {
    const auto exact = sin_cos_turns(turns);
    EXPECT_NEAR(exact.sin * exact.sin + exact.cos * exact.cos, 1, 1e-12) << turns;
  }
  EXPECT_NEAR(sin_cos_turns(2097152.25).sin, 1, 1e-12);
}

TEST(Functions, CubeRootMatchesTheMathematicalLibrary) {
  EXPECT_EQ(cube_root(0.0f), 0.0f);
  EXPECT_EQ(cube_root(-1.0), 0.0);
  for (double x = 1e-9; x < 1e9; x *= 1.0137) {
    EXPECT_NEAR(cube_root(x) / std::cbrt(x), 1, 1e-15) << x;
    const auto single = static_cast<float>(x);
    EXPECT_NEAR(cube_root(single) / std::cbrt(double{single}), 1, 3e-7) << x;
  }
}

TEST(Functions, BinaryLogMatchesTheMathematicalLibrary) {
  EXPECT_EQ(binary_log(1), 0);
  EXPECT_EQ(binary_log(0x1p-1022), -1022);
  EXPECT_EQ(binary_log(0x1p1023), 1023);
  for (double x = 1e-300; x < 1e300; x *= 1.0137) {
    const double expected = std::log2(x);
    EXPECT_NEAR(binary_log(x), expected, 1e-15 * std::fmax(1, std::fabs(expected))) << x;
  }
}

TEST(Functions, BinaryExpMatchesTheMathematicalLibrary) {
  EXPECT_EQ(binary_exp(0), 1);
  EXPECT_EQ(binary_exp(1024), HUGE_VAL);
  EXPECT_EQ(binary_exp(-1023), 0);
  EXPECT_EQ(binary_exp(-HUGE_VAL), 0);
  for (double x = -1022; x < 1024; x += 0.0737) {
    EXPECT_NEAR(binary_exp(x) / std::exp2(x), 1, 1e-15) << x;
  }
}

TEST(Functions, PowerMatchesTheMathematicalLibrary) {
  EXPECT_EQ(power(0, 2.4), 0);
  EXPECT_EQ(power(1, 2.4), 1);
  for (const double y : {0.1, 1 / 2.2, 1.0, 2.0, 2.2, 2.4, 5.0}) {
    for (double x = 1e-9; x < 1e9; x *= 1.0137) {
      const double allowed = 1e-15 * (1 + std::fabs(y * std::log2(x)));
      EXPECT_NEAR(power(x, y) / std::pow(x, y), 1, allowed) << x << " to the " << y;
    }
  }
}

}  // namespace
}  // namespace dapple
