// Every warp against the distribution that it promises, by chi-squared tests.
#include "math/warps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "math/random.h"
#include "tests/statistics/chi_squared.h"

namespace dapple {
namespace {

using test::corrected_significance;
using test::Histogram;

constexpr std::uint32_t kSamples = 400'000;
constexpr std::size_t kTests = 40;  // chi-squared tests in this file
constexpr double kRounding = 4e-7;  // a few units in the last place of 1

std::array<float, 4> random4(std::uint32_t i) { return uniform4(i, 1, 2, 3, 4); }

// The angle of (x, y) as a fraction of a turn, in [0, 1].
double azimuth(double x, double y) { return std::atan2(y, x) / (2 * std::acos(-1.0)) + 0.5; }

void expect_uniform(const Histogram& histogram, const std::string& what) {
  const auto result = test::chi_squared_test_uniform(histogram.counts());
  EXPECT_GT(result.p_value, corrected_significance(kTests)) << what << ": " << result;
}

// The z coordinate and the azimuth about each axis are uniform on the unit sphere.
void expect_uniform_directions(const std::function<Vec3f(std::uint32_t)>& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    Histogram histogram(32, 32);
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      const Vec3f d = direction(i);
      histogram.add(azimuth(d[(axis + 1) % 3], d[(axis + 2) % 3]), (1 + double{d[axis]}) / 2);
    }
    expect_uniform(histogram, "about axis " + std::to_string(axis));
  }
}

TEST(Warps, DiscIsUniform) {
  Histogram polar(32, 32);
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto u = random4(i);
    const Vec3f p = sample_uniform_disc(u[0], u[1]);
    const double squared = double{p.x} * p.x + double{p.y} * p.y;
    ASSERT_LE(squared, 1 + kRounding);
    ASSERT_EQ(p.z, 0.0f);
    polar.add(azimuth(p.x, p.y), squared);
  }
  expect_uniform(polar, "disc");
}

TEST(Warps, SphereIsUniform) {
  expect_uniform_directions([](std::uint32_t i) {
    const auto u = random4(i);
    const Vec3f p = sample_uniform_sphere(u[0], u[1]);
    EXPECT_NEAR(length(p), 1, kRounding);
    return p;
  });
}

TEST(Warps, BallIsUniform) {
  Histogram volume(64);
  Histogram by_direction(16, 64);
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto u = random4(i);
    const Vec3f p = sample_uniform_ball(u[0], u[1], u[2]);
    const double r = length(Vec3d(p));
    ASSERT_LE(r, 1 + kRounding);
    volume.add(r * r * r);
    by_direction.add((1 + p.z / r) / 2, r * r * r);
  }
  expect_uniform(volume, "volume");
  expect_uniform(by_direction, "volume against height");
  expect_uniform_directions([](std::uint32_t i) {
    const auto u = random4(i);
    const Vec3f p = sample_uniform_ball(u[0], u[1], u[2]);
    return p == Vec3f{} ? Vec3f(1, 0, 0) : normalize(p);
  });
}

// Around any normal: the squared sine of the angle to it and the azimuth are uniform.
TEST(Warps, CosineHemisphereIsCosineWeighted) {
  for (std::uint32_t k = 0; k < 12; ++k) {
    const auto v = uniform4(k, 9, 9, 9, 9);
    Vec3f n = sample_uniform_sphere(v[0], v[1]);
    if (k < 6) n = Vec3f(k % 3 == 0, k % 3 == 1, k % 3 == 2) * (k < 3 ? 1.0f : -1.0f);
    const Vec3d side = std::fabs(n.x) < 0.5f ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d a = normalize(cross(side, Vec3d(n))), b = cross(Vec3d(n), a);
    Histogram polar(24, 24);
    for (std::uint32_t i = 0; i < kSamples / 4; ++i) {
      const auto u = uniform4(i, k, 0, 0, 5);
      const Vec3f d = sample_cosine_hemisphere(n, u[0], u[1]);
      ASSERT_NEAR(length(d), 1, kRounding);
      const double cosine = dot(Vec3d(d), Vec3d(n));
      ASSERT_GE(cosine, -kRounding);
      polar.add(azimuth(dot(Vec3d(d), a), dot(Vec3d(d), b)), 1 - cosine * cosine);
    }
    expect_uniform(polar, "normal " + std::to_string(k));
  }
}

// The corners of the unit square, where roots and quotients meet their limits.
TEST(Warps, ExtremeNumbersGiveFinitePointsOfTheDomain) {
  const float extremes[] = {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, 1.0f - 0x1p-24f};
  for (const float u : extremes) {
    for (const float v : extremes) {
      for (const float w : extremes) {
        EXPECT_LE(length(sample_uniform_disc(u, v)), 1 + kRounding);
        EXPECT_NEAR(length(sample_uniform_sphere(u, v)), 1, kRounding);
        EXPECT_LE(length(sample_uniform_ball(u, v, w)), 1 + kRounding);
        for (const Vec3f n : {Vec3f(0, 0, 1), Vec3f(0, 0, -1), Vec3f(0.6f, 0, -0.8f)}) {
          const Vec3f d = sample_cosine_hemisphere(n, u, v);
          EXPECT_NEAR(length(d), 1, kRounding) << u << " " << v;
          EXPECT_GE(dot(d, n), -kRounding) << u << " " << v;
        }
      }
    }
  }
}

// That these tests can fail: the usual mistakes.
TEST(Warps, MistakesWouldBeFound) {
  Histogram crowded_centre(32, 32), square_root_ball(64), uniform_hemisphere(24, 24);
  for (std::uint32_t i = 0; i < kSamples / 4; ++i) {
    const auto u = random4(i);
    crowded_centre.add(u[0], double{u[1]} * u[1]);          // r = u in place of sqrt(u)
    square_root_ball.add(std::pow(double{u[2]}, 1.5));      // r = sqrt(u)
    uniform_hemisphere.add(u[0], 1 - double{u[1]} * u[1]);  // cos = u
  }
  for (const Histogram* wrong : {&crowded_centre, &square_root_ball, &uniform_hemisphere}) {
    EXPECT_LT(test::chi_squared_test_uniform(wrong->counts()).p_value, 1e-9);
  }
}

}  // namespace
}  // namespace dapple
