// What sample() draws is distributed as pdf() says, and weighted as evaluate() says.
#include <gtest/gtest.h>

#include <numeric>

#include "math/random.h"
#include "tests/shading/surface_cases.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

// Cells of equal solid angle over the whole sphere.
constexpr std::size_t kHeights = 24, kTurns = 24, kCells = kHeights * kTurns;
constexpr std::uint32_t kSamples = 100'000;

std::size_t cell_of(const Vec3f& w) {
  const float turns = fast_atan2(w.y, w.x) * (0.5f * kInvPi);
  const auto row = static_cast<std::size_t>((w.z + 1) * 0.5f * kHeights);
  const auto column = static_cast<std::size_t>((turns < 0 ? turns + 1 : turns) * kTurns);
  return std::min(row, kHeights - 1) * kTurns + std::min(column, kTurns - 1);
}

// The last cell is for what has no density: samples of one direction, and none at all.
std::vector<double> expected_counts(const Bsdf& bsdf) {
  constexpr std::size_t kSub = 32;
  std::vector<double> counts(kCells + 1);
  for (std::size_t row = 0; row < kHeights * kSub; ++row) {
    const float z = (static_cast<float>(row) + 0.5f) * 2 / (kHeights * kSub) - 1;
    for (std::size_t column = 0; column < kTurns * kSub; ++column) {
      const Vec3f w = direction_at(z, (static_cast<float>(column) + 0.5f) / (kTurns * kSub));
      counts[row / kSub * kTurns + column / kSub] += bsdf.pdf(w);
    }
  }
  for (double& count : counts) count *= 4 * double{kPi} / (kCells * kSub * kSub) * kSamples;
  counts[kCells] = std::max(0.0, kSamples - std::accumulate(counts.begin(), counts.end(), 0.0));
  return counts;
}

std::vector<double> observed_counts(const Bsdf& bsdf) {
  std::vector<double> counts(kCells + 1);
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto u = uniform4(i, 1, 2, 3, 11);
    const auto sample = bsdf.sample(u[0], {u[1], u[2]});
    ++counts[sample && !sample->specular ? cell_of(sample->wi) : kCells];
  }
  return counts;
}

class BsdfSampling : public testing::TestWithParam<float> {};

TEST_P(BsdfSampling, FollowsTheDensity) {
  const auto cases = surface_cases(GetParam());
  const double level = corrected_significance(2 * cases.size() * 4);
  for (const SurfaceCase& surface : cases) {
    if (surface.is_narrow) continue;
    for (const float cosine : {0.3f, 0.9f}) {
      const Bsdf bsdf = bsdf_of(surface, direction_at(cosine, 0.07f));
      const ChiSquared fit = chi_squared_test(observed_counts(bsdf), expected_counts(bsdf));
      EXPECT_GT(fit.p_value, level) << surface.name << " at cosine " << cosine << ": " << fit;
    }
  }
}

TEST_P(BsdfSampling, WeighsByValueOverDensity) {
  for (const SurfaceCase& surface : surface_cases(GetParam())) {
    const Bsdf bsdf = bsdf_of(surface, direction_at(0.6f, 0.3f));
    for (std::uint32_t i = 0; i < 200; ++i) {
      const auto u = uniform4(i, 0, 0, 0, 5);
      const auto sample = bsdf.sample(u[0], {u[1], u[2]});
      if (!sample || sample->specular) continue;
      const BsdfValue value = bsdf.evaluate(sample->wi);
      EXPECT_NEAR(sample->pdf, value.pdf, 1e-3f * value.pdf) << surface.name;
      EXPECT_NEAR(sample->weight.x * value.pdf, value.f.x, 1e-3f * value.f.x) << surface.name;
      EXPECT_NEAR(dot(sample->wi, sample->wi), 1, 1e-5) << surface.name;
      EXPECT_EQ(sample->transmitted, sample->wi.z < 0) << surface.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Roughness, BsdfSampling, testing::Values(0.0f, 0.5f, 0.7f, 1.0f));

}  // namespace
}  // namespace dapple::test
