#include "shading/medium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "math/warps.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

TEST(Medium, AbsorbsByBeersLaw) {
  const Medium medium{{0.5f, 1, 0}, {0, 2, 0}, 0};
  const Vec3f t = transmittance(medium, 0.7f);
  EXPECT_NEAR(t.x, std::exp(-0.35), 1e-6);
  EXPECT_NEAR(t.y, std::exp(-2.1), 1e-6);
  EXPECT_EQ(t.z, 1);
  EXPECT_EQ(transmittance(medium, INFINITY).y, 0);
}

TEST(Medium, WithoutScatteringThePathGoesOn) {
  const Medium medium{{1, 2, 3}, {}, 0};
  const MediumSample s = sample_distance(medium, 2, {1, 1, 1}, 0.3f, 0.9f);
  EXPECT_FALSE(s.scattered);
  EXPECT_NEAR(s.weight.y, std::exp(-4.0), 1e-6);
}

// The mean weight of what goes through is the transmittance, and that of what scatters is the rest
// times the scattering's part, whatever the channels' coefficients and the throughput.
TEST(Medium, DistancesAreWeighedWithoutBias) {
  const Medium medium{{0.1f, 0.5f, 0}, {2, 0.5f, 1}, 0};
  constexpr float kDistance = 0.8f;
  constexpr std::uint32_t kGrid = 400;
  for (const Vec3f& throughput : {Vec3f(1, 1, 1), Vec3f(0.1f, 3, 1)}) {
    Vec3d through, scattered;
    for (std::uint32_t i = 0; i < kGrid; ++i) {
      for (std::uint32_t j = 0; j < kGrid; ++j) {
        const MediumSample s =
            sample_distance(medium, kDistance, throughput, (static_cast<float>(i) + 0.5f) / kGrid,
                            (static_cast<float>(j) + 0.5f) / kGrid);
        (s.scattered ? scattered : through) =
            (s.scattered ? scattered : through) + Vec3d(s.weight) / double{kGrid * kGrid};
      }
    }
    for (int c = 0; c < 3; ++c) {
      const double extinction = medium.absorption[c] + medium.scattering[c];
      const double t = std::exp(-extinction * kDistance);
      EXPECT_NEAR(through[c], t, 0.01);
      EXPECT_NEAR(scattered[c], (1 - t) * medium.scattering[c] / extinction, 0.01);
    }
  }
}

TEST(Medium, PhaseFunctionIsADensityWithItsMeanCosine) {
  for (const float g : {-0.7f, 0.0f, 0.3f, 0.9f}) {
    constexpr int kSteps = 20'000;
    double sum = 0, cosine_sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double cosine = 2 * (i + 0.5) / kSteps - 1;
      const double value = phase(static_cast<float>(cosine), g) * 4 * 3.141592653589793 / kSteps;
      sum += value;
      cosine_sum += cosine * value;
    }
    EXPECT_NEAR(sum, 1, 1e-3) << g;
    EXPECT_NEAR(cosine_sum, g, 1e-3);
  }
}

TEST(Medium, PhaseSamplesFollowTheDensity) {
  const Vec3f forward = normalize(Vec3f(1, -2, 0.5f));
  for (const float g : {-0.5f, 0.0f, 0.8f}) {
    constexpr std::size_t kCells = 50, kSub = 50;
    std::vector<double> expected(kCells);
    for (std::size_t i = 0; i < kCells * kSub; ++i) {
      expected[i / kSub] += phase(2 * (static_cast<float>(i) + 0.5f) / (kCells * kSub) - 1, g);
    }
    Histogram found(kCells);
    for (std::uint32_t i = 0; i < 20'000; ++i) {
      const auto u = uniform4(i, 0, 0, 0, 6);
      found.add((dot(sample_phase(forward, g, {u[0], u[1]}), forward) + 1) / 2);
    }
    const ChiSquared fit = chi_squared_test(found.counts(), expected);
    EXPECT_GT(fit.p_value, corrected_significance(3)) << g << ": " << fit;
  }
}

}  // namespace
}  // namespace dapple::test
