#include "math/functions.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Functions, CubeRootMatchesTheMathematicalLibrary) {
  EXPECT_EQ(cube_root(0.0f), 0.0f);
  EXPECT_EQ(cube_root(-1.0), 0.0);
  for (double x = 1e-9; x < 1e9; x *= 1.0137) {
    EXPECT_NEAR(cube_root(x) / std::cbrt(x), 1, 1e-15) << x;
    const auto single = static_cast<float>(x);
    EXPECT_NEAR(cube_root(single) / std::cbrt(double{single}), 1, 3e-7) << x;
  }
}

}  // namespace
}  // namespace dapple
