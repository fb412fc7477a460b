#include "dapple/scaling/laws.h"

#include <gtest/gtest.h>

#include <vector>

namespace dapple::scaling {
namespace {

constexpr double kRounding = 1e-12;

using Law = double (*)(double serial, double threads);

std::vector<SpeedupPoint> points_of(Law law, double serial, const std::vector<int>& threads) {
  std::vector<SpeedupPoint> points;
  for (const double n : threads) points.push_back({n, law(serial, n)});
  return points;
}

TEST(Laws, KnownValues) {
  EXPECT_DOUBLE_EQ(amdahl_speedup(0, 16), 16);
  EXPECT_DOUBLE_EQ(amdahl_speedup(1, 16), 1);
  EXPECT_NEAR(amdahl_speedup(0.1, 10), 1 / 0.19, kRounding);
  EXPECT_NEAR(amdahl_speedup(0.05, 1e15), 20, 1e-9);  // never more than 1 / s
  EXPECT_DOUBLE_EQ(gustafson_speedup(0, 16), 16);
  EXPECT_DOUBLE_EQ(gustafson_speedup(1, 16), 1);
  EXPECT_DOUBLE_EQ(gustafson_speedup(0.1, 11), 10);
}

TEST(Laws, AFitFindsTheFractionThatMadeThePoints) {
  for (const double serial : {0.0, 0.01, 0.3, 1.0, -0.05}) {
    for (const std::vector<int>& threads : {std::vector<int>{1, 2}, {1, 2, 4, 8}, {3, 64}}) {
      EXPECT_NEAR(*fit_amdahl(points_of(amdahl_speedup, serial, threads)), serial, kRounding);
      EXPECT_NEAR(*fit_gustafson(points_of(gustafson_speedup, serial, threads)), serial, kRounding);
    }
  }
}

TEST(Laws, AFitLiesBetweenContradictingPoints) {
  const std::vector<SpeedupPoint> amdahl = {{2, amdahl_speedup(0.1, 2)},
                                            {4, amdahl_speedup(0.3, 4)}};
  // By hand: weights (1 - 1/n)^2 are 1/4 and 9/16.
  EXPECT_NEAR(*fit_amdahl(amdahl), (0.1 / 4 + 0.3 * 9 / 16) / (1.0 / 4 + 9.0 / 16), kRounding);
  const std::vector<SpeedupPoint> gustafson = {{2, gustafson_speedup(0.1, 2)},
                                               {4, gustafson_speedup(0.3, 4)}};
  // Weights (n - 1)^2 are 1 and 9.
  EXPECT_NEAR(*fit_gustafson(gustafson), (0.1 + 0.3 * 9) / 10, kRounding);
}

TEST(Laws, OneThreadAloneFitsNothing) {
  const std::vector<SpeedupPoint> one = {{1, 1}};
  EXPECT_FALSE(fit_amdahl(one));
  EXPECT_FALSE(fit_gustafson(one));
  EXPECT_FALSE(fit_amdahl({}));
}

}  // namespace
}  // namespace dapple::scaling
