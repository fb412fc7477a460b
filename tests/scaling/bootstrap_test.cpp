#include "dapple/scaling/bootstrap.h"

#include <gtest/gtest.h>

#include "math/random.h"

namespace dapple::scaling {
namespace {

TEST(Bootstrap, MedianAndPercentiles) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(percentile({10, 0, 20}, 0), 0);
  EXPECT_EQ(percentile({10, 0, 20}, 1), 20);
  EXPECT_EQ(percentile({10, 0, 20}, 0.25), 5);
}

std::vector<Estimate> estimate_mean(const std::vector<double>& values) {
  return bootstrap(values.size(), [&](std::span<const std::size_t> rounds) {
    double sum = 0;
    for (const std::size_t round : rounds) sum += values.at(round);
    return std::vector<double>{sum / static_cast<double>(rounds.size())};
  });
}

TEST(Bootstrap, EqualRoundsLeaveNoDoubt) {
  const Estimate e = estimate_mean({3, 3, 3, 3})[0];
  EXPECT_EQ(e.value, 3);
  EXPECT_EQ(e.low, 3);
  EXPECT_EQ(e.high, 3);
  EXPECT_EQ(e.uncertainty(), 0);
}

// For the mean the interval is known: 1.96 standard deviations over the root of the number. The
// ends of 2000 draws are themselves uncertain by about 5 % of that; 20 % leaves room.
TEST(Bootstrap, TheIntervalOfAMeanIsThatOfTheory) {
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(i % 2);
  const Estimate e = estimate_mean(values)[0];
  const double half = 1.96 * 0.5 / 20;
  EXPECT_EQ(e.value, 0.5);
  EXPECT_NEAR(e.low, 0.5 - half, 0.2 * half);
  EXPECT_NEAR(e.high, 0.5 + half, 0.2 * half);
}

// 95 % of such intervals hold the truth; of 200 seldom fewer than 176 do (four standard
// deviations below 190, and the bootstrap of 30 values is a little too narrow).
TEST(Bootstrap, IntervalsHoldTheTruthAsOftenAsTheySay) {
  int hits = 0;
  for (std::uint32_t trial = 0; trial < 200; ++trial) {
    std::vector<double> values;
    for (std::uint32_t i = 0; i < 30; ++i) {
      values.push_back(uniform_float(philox4x32({i, trial, 1, 2}, 3)[0]));
    }
    const Estimate e = estimate_mean(values)[0];
    if (e.low <= 0.5 && 0.5 <= e.high) ++hits;
  }
  EXPECT_GE(hits, 176);
  EXPECT_LT(hits, 200);
}

TEST(Bootstrap, WholeRoundsAreDrawnSoThatSharedNoiseCancels) {
  const std::vector<double> slow = {2, 4, 20, 6, 2}, fast = {1, 2, 10, 3, 1};
  const auto e = bootstrap(5, [&](std::span<const std::size_t> rounds) {
    double a = 0, b = 0;
    for (const std::size_t round : rounds) {
      a += slow[round];
      b += fast[round];
    }
    return std::vector<double>{a / b, a};
  });
  EXPECT_EQ(e[0].low, 2);
  EXPECT_EQ(e[0].high, 2);
  EXPECT_LT(e[1].low, e[1].high);
}

}  // namespace
}  // namespace dapple::scaling
