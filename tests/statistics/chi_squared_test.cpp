#include "tests/statistics/chi_squared.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dapple::test {
namespace {

TEST(ChiSquared, TailMatchesClosedForms) {
  for (double x = 0.25; x < 80; x *= 1.3) {
    // Two degrees: exponential. One: the square of a normal. Six: a Poisson sum.
    EXPECT_NEAR(chi_squared_tail(x, 2) / std::exp(-x / 2), 1, 1e-12);
    EXPECT_NEAR(chi_squared_tail(x, 1) / normal_two_sided_tail(std::sqrt(x)), 1, 1e-10);
    const double h = x / 2;
    EXPECT_NEAR(chi_squared_tail(x, 6) / (std::exp(-h) * (1 + h + h * h / 2)), 1, 1e-12);
  }
  EXPECT_NEAR(chi_squared_tail(1000, 1000), 0.4941, 1e-4);
}

TEST(ChiSquared, SmallBinsArePooled) {
  const std::vector<double> observed = {1, 0, 2, 1, 50, 46};
  const std::vector<double> expected = {1, 1, 1, 1, 48, 48};
  const ChiSquared result = chi_squared_test(observed, expected);
  EXPECT_EQ(result.degrees, 1u);  // two bins: the four small ones joined the first that suffices
}

TEST(ChiSquared, CountsWhereNothingIsPossibleAreRejected) {
  EXPECT_EQ(chi_squared_test(std::vector<double>{1, 99}, std::vector<double>{0, 100}).p_value, 0);
}

// The p-values of true hypotheses are themselves uniform; those of a slightly false one are not.
TEST(ChiSquared, PValuesAreUniformWhenTheDistributionIsRight) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  Histogram p_values(20);
  std::size_t rejected = 0;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    Histogram right(10, 10), wrong(10, 10);
    for (int i = 0; i < 3000; ++i) {
      const double u = uniform(random), v = uniform(random);
      right.add(u, v);
      wrong.add(std::pow(u, 1.3), v);
    }
    p_values.add(chi_squared_test_uniform(right.counts()).p_value);
    rejected += chi_squared_test_uniform(wrong.counts()).p_value < kSignificance;
  }
  EXPECT_GT(chi_squared_test_uniform(p_values.counts()).p_value, kSignificance);
  EXPECT_GT(rejected, 1900u);
}

}  // namespace
}  // namespace dapple::test
