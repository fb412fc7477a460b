#include "render/pixel_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dapple {
namespace {

struct Moments {
  double mean = 0, variance = 0, low = 1, high = 0;
};

Moments moments_of(FilterKind kind) {
  const PixelFilter filter(kind);
  constexpr int kCount = 100000;
  Moments m;
  for (int i = 0; i < kCount; ++i) {
    const double x = filter.place((static_cast<float>(i) + 0.5f) / kCount);
    m.mean += x / kCount;
    m.variance += (x - 0.5) * (x - 0.5) / kCount;
    m.low = std::fmin(m.low, x);
    m.high = std::fmax(m.high, x);
  }
  return m;
}

TEST(PixelFilter, BoxIsThePixelItself) {
  EXPECT_EQ(PixelFilter(FilterKind::box).place(0.3f), 0.3f);
  EXPECT_NEAR(moments_of(FilterKind::box).variance, 1.0 / 12, 1e-4);
}

TEST(PixelFilter, GaussianHasItsDeviation) {
  const Moments m = moments_of(FilterKind::gaussian);
  EXPECT_NEAR(m.mean, 0.5, 1e-4);
  // Cut at three deviations, a normal distribution keeps 0.9733 of its variance.
  EXPECT_NEAR(m.variance, 0.9733 * 0.16, 1e-3);
  EXPECT_GE(m.low, 0.5 - 1.2);
  EXPECT_LE(m.high, 0.5 + 1.2);
}

// The variance of the window w(x) = sum a_k cos(pi k x) over (-1, 1), in closed form:
// integral of x^2 cos(pi k x) = 4 (-1)^k / (pi k)^2, alternating signs as in the window.
TEST(PixelFilter, BlackmanHarrisHasItsVariance) {
  const double a[] = {0.35875, 0.48829, 0.14128, 0.01168};
  double second = 2.0 / 3 * a[0];
  for (int k = 1; k < 4; ++k) second += 4 * a[k] / std::pow(M_PI * k, 2) * (k % 2 ? -1 : 1);
  const Moments m = moments_of(FilterKind::blackman_harris);
  EXPECT_NEAR(m.mean, 0.5, 1e-4);
  EXPECT_NEAR(m.variance, 1.5 * 1.5 * second / (2 * a[0]), 1e-4);
  EXPECT_GE(m.low, -1);
  EXPECT_LE(m.high, 2);
}

TEST(PixelFilter, NeverTurnsBack) {
  for (const auto kind : {FilterKind::gaussian, FilterKind::blackman_harris}) {
    const PixelFilter filter(kind);
    float last = filter.place(0);
    for (int i = 1; i < (1 << 12); ++i) {
      const float place = filter.place(static_cast<float>(i) / (1 << 12));
      ASSERT_GE(place, last);
      last = place;
    }
  }
}

TEST(PixelFilter, UnknownNamesListTheKnown) {
  EXPECT_EQ(parse_filter("gaussian").value(), FilterKind::gaussian);
  EXPECT_FALSE(parse_filter("lanczos"));
}

}  // namespace
}  // namespace dapple
