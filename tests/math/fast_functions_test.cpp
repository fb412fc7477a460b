#include "math/fast_functions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/frame.h"
#include "math/warps.h"

namespace dapple {
namespace {

TEST(FastFunctions, FloorOfNegativesAndWholes) {
  for (const float x : {-3.0f, -2.5f, -0.0f, 0.0f, 0.3f, 7.0f, 7.9999f, -1e-9f}) {
    EXPECT_EQ(floor_to_int(x), static_cast<int>(std::floor(x))) << x;
  }
}

TEST(FastFunctions, PowersOfTwo) {
  EXPECT_EQ(fast_exp2(0), 1);
  EXPECT_EQ(fast_exp2(-127), 0);
  EXPECT_EQ(fast_exp2(-INFINITY), 0);
  EXPECT_EQ(fast_exp2(1000), 0x1p127f);
  for (float x = -125; x < 127; x += 0.0137f) {
    EXPECT_NEAR(fast_exp2(x) / std::exp2(double{x}), 1, 2.5e-7) << x;
  }
}

TEST(FastFunctions, Logarithms) {
  EXPECT_EQ(fast_log2(1), 0);
  EXPECT_EQ(fast_log2(0x1p100f), 100);
  for (float x = 1e-37f; x < 1e37f; x *= 1.0137f) {
    const double expected = std::log2(double{x});
    EXPECT_NEAR(fast_log2(x), expected, 2e-7 * std::fmax(1, std::fabs(expected))) << x;
  }
}

TEST(FastFunctions, Exponentials) {
  for (float x = -20; x < 20; x += 0.0137f) {
    EXPECT_NEAR(fast_exp(x) / std::exp(double{x}), 1, 3e-6) << x;
  }
  for (float x = 1e-6f; x < 1e6f; x *= 1.137f) {
    EXPECT_NEAR(fast_log(x), std::log(double{x}), 1e-6 + 3e-7 * std::fabs(std::log(double{x})));
  }
}

TEST(FastFunctions, Powers) {
  EXPECT_EQ(fast_pow(0, 2), 0);
  EXPECT_EQ(fast_pow(1, 7), 1);
  for (const float y : {0.2f, 1.0f, 2.2f, 10.0f}) {
    for (float x = 1e-3f; x < 1e2f; x *= 1.137f) {
      const double exact = std::pow(double{x}, double{y});
      EXPECT_NEAR(fast_pow(x, y) / exact, 1, 3e-7 * (2 + std::fabs(std::log2(exact)))) << x;
    }
  }
}

TEST(FastFunctions, AnglesAllAround) {
  EXPECT_EQ(fast_atan2(0, 0), 0);
  for (double angle = -3.14159; angle < 3.14159; angle += 0.000917) {
    for (const double length : {1e-10, 1.0, 1e10}) {
      const auto x = static_cast<float>(length * std::cos(angle));
      const auto y = static_cast<float>(length * std::sin(angle));
      EXPECT_NEAR(fast_atan2(y, x), std::atan2(double{y}, double{x}), 4e-7) << angle;
    }
  }
}

TEST(FastFunctions, Arccosine) {
  EXPECT_EQ(fast_acos(1), 0);
  EXPECT_EQ(fast_acos(2), 0);
  EXPECT_NEAR(fast_acos(-1), M_PI, 4e-7);
  for (float x = -1; x <= 1; x += 0.000917f) {
    EXPECT_NEAR(fast_acos(x), std::acos(double{x}), 5e-7) << x;
  }
}

TEST(FastFunctions, SineOfRadians) {
  for (float x = -100; x < 100; x += 0.0917f) {
    EXPECT_NEAR(sin_cos(x).sin, std::sin(double{x}), 2e-5) << x;
    EXPECT_NEAR(sin_cos(x / 32).cos, std::cos(double{x / 32}), 1e-6) << x;
  }
}

TEST(Frame, IsOrthonormalAroundItsNormal) {
  for (int i = 0; i < 1000; ++i) {
    const Vec3f n = sample_uniform_sphere((static_cast<float>(i) + 0.5f) / 1000,
                                          0.61803f * static_cast<float>(i));
    for (const Frame& f : {frame_around(n), frame_along(n, {0, 0, 1})}) {
      EXPECT_NEAR(dot(f.tangent, f.normal), 0, 1e-5);
      EXPECT_NEAR(dot(f.tangent, f.tangent), 1, 1e-5);
      EXPECT_NEAR(dot(cross(f.normal, f.tangent), f.bitangent), 1, 1e-5);
      EXPECT_NEAR(length(f.to_world(f.to_local({1, 2, 3})) - Vec3f(1, 2, 3)), 0, 1e-5);
    }
  }
}

}  // namespace
}  // namespace dapple
