#include "render/path_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "math/sobol.h"

namespace dapple {
namespace {

using Point = std::array<float, 4>;

// The samples of one pixel.
std::vector<Point> points_of(const PathSampler& sampler, std::uint32_t x, std::uint32_t y,
                             std::uint32_t count, std::uint32_t dimension) {
  std::vector<Point> points;
  for (std::uint32_t s = 0; s < count; ++s) {
    points.push_back(sampler.uniform4(x, y, s, dimension));
  }
  return points;
}

int cell(float u, int cells) { return static_cast<int>(u * static_cast<float>(cells)); }

// True when each of the equal rectangles columns x rows holds exactly one of the points.
bool is_stratified(const std::vector<Point>& points, std::size_t a, std::size_t b, int columns,
                   int rows) {
  std::set<int> seen;
  for (const Point& p : points) seen.insert(cell(p[a], columns) + columns * cell(p[b], rows));
  return static_cast<int>(points.size()) == columns * rows && seen.size() == points.size();
}

// Every elementary interval of the first two Sobol dimensions holds one point, whatever scrambling
// and shuffling did: the property that makes the sequence better than chance.
TEST(PathSampler, SamplesOfAPixelAreStratifiedInAllElementaryIntervals) {
  const PathSampler sampler(64, 7);
  for (const std::uint32_t x : {0u, 3u, 255u, 256u, 4000u}) {
    for (std::uint32_t dimension = 0; dimension < 5; ++dimension) {
      const auto points = points_of(sampler, x, 11, 64, dimension);
      for (int columns = 1; columns <= 64; columns *= 2) {
        EXPECT_TRUE(is_stratified(points, 0, 1, columns, 64 / columns)) << x << ' ' << columns;
      }
      for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(is_stratified(points, i, i, 64, 1));
    }
  }
}

// An aligned block of pixels shares one sequence: together its samples are stratified as finely as
// their number allows.
TEST(PathSampler, AlignedBlocksOfPixelsAreStratifiedTogether) {
  const PathSampler sampler(4, 1);
  std::vector<Point> points;
  for (std::uint32_t y = 8; y < 12; ++y) {
    for (std::uint32_t x = 16; x < 20; ++x) {
      for (const Point& p : points_of(sampler, x, y, 4, 3)) points.push_back(p);
    }
  }
  for (int columns = 1; columns <= 64; columns *= 2) {
    EXPECT_TRUE(is_stratified(points, 0, 1, columns, 64 / columns)) << columns;
  }
}

TEST(PathSampler, DependsOnEveryKey) {
  const PathSampler sampler(16, 5), other_seed(16, 6), high_seed(16, 5 + (std::uint64_t{1} << 40));
  const Point base = sampler.uniform4(3, 4, 5, 6);
  EXPECT_EQ(base, sampler.uniform4(3, 4, 5, 6));
  EXPECT_NE(base, sampler.uniform4(2, 4, 5, 6));
  EXPECT_NE(base, sampler.uniform4(3, 5, 5, 6));
  EXPECT_NE(base, sampler.uniform4(3, 4, 6, 6));
  EXPECT_NE(base, sampler.uniform4(3, 4, 5, 7));
  EXPECT_NE(base, sampler.uniform4(3 + 256, 4, 5, 6));
  EXPECT_NE(base, other_seed.uniform4(3, 4, 5, 6));
  EXPECT_NE(base, high_seed.uniform4(3, 4, 5, 6));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5);
  return 12 * sum / static_cast<double>(a.size());  // a uniform number's variance is 1/12
}

// Decisions must not know of each other: 4096 pairs correlate by chance with a deviation of 1/64.
TEST(PathSampler, DimensionsAreUncorrelated) {
  const PathSampler sampler(1, 9);
  const auto column = [&](std::uint32_t dimension, std::size_t i) {
    std::vector<double> values;
    for (std::uint32_t p = 0; p < 4096; ++p) {
      values.push_back(sampler.uniform4(p % 64, p / 64, 0, dimension)[i]);
    }
    return values;
  };
  for (std::uint32_t d = 0; d < 6; ++d) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT(std::fabs(correlation(column(d, i), column(d + 1, 3 - i))), 5.0 / 64) << d;
    }
  }
}

// Errors of neighbouring pixels cancel: the mean over a block of pixels is nearer the truth than
// with as many independent numbers.
TEST(PathSampler, ErrorsOfNeighboursCancel) {
  const PathSampler sampler(1, 2);
  const auto value = [](const Point& p) { return p[0] * p[1]; };  // mean 1/4, variance 7/144
  double squared_error = 0;
  constexpr int kBlocks = 256, kSide = 4;
  for (std::uint32_t block = 0; block < kBlocks; ++block) {
    double sum = 0;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      sum += value(
          sampler.uniform4(block % 16 * kSide + i % kSide, block / 16 * kSide + i / kSide, 0, 0));
    }
    const double error = sum / (kSide * kSide) - 0.25;
    squared_error += error * error / kBlocks;
  }
  EXPECT_LT(squared_error, 0.25 * (7.0 / 144) / (kSide * kSide));
}

TEST(PathSampler, TakesTheLargestSampleCount) {
  const PathSampler sampler(1 << 24, 0);
  for (const std::uint32_t s : {0u, 1u, (1u << 24) - 1}) {
    for (const float u : sampler.uniform4(1u << 19, 77, s, 1000)) {
      EXPECT_GE(u, 0.0f);
      EXPECT_LT(u, 1.0f);
    }
  }
}

}  // namespace
}  // namespace dapple
