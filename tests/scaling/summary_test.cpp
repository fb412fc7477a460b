#include "dapple/scaling/summary.h"

#include <gtest/gtest.h>

#include "tests/scaling/made_up_runs.h"

namespace dapple::scaling {
namespace {

constexpr double kRounding = 1e-9;

TEST(Summary, FindsTheLawThatMadeTheTimes) {
  const Measurements m = made_up_runs({WorkKind::ray}, {1, 2, 4, 8}, 5, 0.1);
  const auto curves = make_curves(m, 8);
  ASSERT_EQ(curves.size(), 2u);
  for (const Curve& curve : curves) {
    ASSERT_TRUE(curve.serial_fraction);
    EXPECT_NEAR(curve.serial_fraction->value, 0.1, kRounding);
    ASSERT_EQ(curve.points.size(), 4u);
    for (const Point& p : curve.points) {
      const double expected = curve.mode == Mode::strong ? amdahl_speedup(0.1, p.threads)
                                                         : gustafson_speedup(0.1, p.threads);
      EXPECT_NEAR(p.speedup.value, expected, kRounding);
      EXPECT_NEAR(p.efficiency.value, expected / p.threads, kRounding);
      EXPECT_NEAR(fitted_speedup(curve, p.threads), expected, kRounding);
      EXPECT_DOUBLE_EQ(p.imbalance.value, 1);
    }
  }
  EXPECT_TRUE(find_warnings(curves, m, quiet_machine(8), true).empty());
}

TEST(Summary, PointsWithoutCoresAreLeftOutOfTheFitAndMarked) {
  Measurements m = made_up_runs({WorkKind::build}, {1, 2, 4}, 5, 0.2);
  for (std::size_t i = 0; i < m.plan.size(); ++i) {
    if (m.plan[i].threads == 4) m.samples[i].assign(5, sample_of(100, 4));
  }
  const auto curves = make_curves(m, 2);
  for (const Curve& curve : curves) {
    EXPECT_NEAR(curve.serial_fraction->value, 0.2, kRounding);
    EXPECT_FALSE(curve.points[1].oversubscribed);
    EXPECT_TRUE(curve.points[2].oversubscribed);
  }
  const auto warnings = find_warnings(curves, m, quiet_machine(2), true);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with("4 threads on 2 cores")) << warnings[0];
}

TEST(Summary, OneThreadHasNoFitAndSaysSo) {
  const Measurements m = made_up_runs({WorkKind::ray}, {1}, 5, 0);
  const auto curves = make_curves(m, 4);
  EXPECT_FALSE(curves[0].serial_fraction);
  EXPECT_EQ(find_warnings(curves, m, quiet_machine(4), true).size(), 1u);
}

TEST(Summary, NoiseWidensTheIntervalAndWarns) {
  Measurements m = made_up_runs({WorkKind::ray}, {1, 2}, 9, 0);
  for (std::size_t round = 0; round < 9; ++round) {
    m.samples[0][round].wall = 1 + 0.1 * static_cast<double>(round % 5);
  }
  const auto curves = make_curves(m, 2);
  EXPECT_GT(curves[0].points[0].seconds.uncertainty(), kNoisy);
  EXPECT_LE(curves[0].points[1].speedup.low, curves[0].points[1].speedup.value);
  EXPECT_GE(curves[0].points[1].speedup.high, curves[0].points[1].speedup.value);
  const auto warnings = find_warnings(curves, m, quiet_machine(2), true);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("uncertain by more than 5 %"), std::string::npos);
}

TEST(Summary, WhatSlowsAWholeRoundLeavesTheSpeedUpAlone) {
  Measurements m = made_up_runs({WorkKind::ray}, {1, 2}, 9, 0.1);
  for (auto& runs : m.samples) {
    for (std::size_t round = 0; round < 9; ++round) {
      runs[round].wall *= 1 + static_cast<double>(round);
    }
  }
  const auto curves = make_curves(m, 2);
  for (const Curve& curve : curves) {
    EXPECT_NEAR(curve.serial_fraction->low, 0.1, kRounding);
    EXPECT_NEAR(curve.serial_fraction->high, 0.1, kRounding);
    EXPECT_GT(curve.points[1].seconds.uncertainty(), kNoisy);
  }
}

TEST(Summary, OtherLoadFewRoundsAndRefusedPinningWarn) {
  Measurements m = made_up_runs({WorkKind::ray}, {1, 2}, 2, 0);
  m.pinned = false;
  Machine machine = quiet_machine(2);
  machine.activity = {0.5, 0.25};
  const auto curves = make_curves(m, 2);
  EXPECT_EQ(find_warnings(curves, m, machine, true).size(), 4u);
  EXPECT_EQ(find_warnings(curves, m, machine, false).size(), 3u);
}

TEST(Summary, ImbalanceIsTheLongestOverTheMean) {
  Sample sample;
  EXPECT_EQ(sample.imbalance(), 1);
  sample.busy = {{3, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(sample.imbalance(), 1.5);
  sample.busy = {{3, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(sample.imbalance(), 3);
}

}  // namespace
}  // namespace dapple::scaling
