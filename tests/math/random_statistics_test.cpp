// The random numbers that samples are made of: uniform, and independent between the numbers of a
// block, neighbouring pixels, samples, dimensions and seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "math/random.h"
#include "tests/statistics/chi_squared.h"

namespace dapple {
namespace {

using test::Histogram;

constexpr std::uint32_t kCount = 1u << 18;
constexpr std::size_t kTests = 150;  // tests in this file

using Block = std::array<float, 4>;

// The block of the i-th of many (pixel, sample, dimension, seed) as a renderer counts them, moved
// by the given steps.
Block block_at(std::uint32_t i, std::uint32_t dx, std::uint32_t dy, std::uint32_t ds,
               std::uint32_t dd, std::uint64_t seed_step) {
  return uniform4((i & 511) + dx, (i >> 9 & 63) + dy, (i >> 15 & 3) + ds, (i >> 17 & 1) + dd,
                  seed_step);
}

void expect_fit(const Histogram& histogram, const std::string& what) {
  const auto result = test::chi_squared_test_uniform(histogram.counts());
  EXPECT_GT(result.p_value, test::corrected_significance(kTests)) << what << ": " << result;
}

TEST(RandomStatistics, EachNumberIsUniformInHighAndLowBits) {
  for (std::size_t k = 0; k < 4; ++k) {
    Histogram high(1024), low(1024);
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const float u = block_at(i, 0, 0, 0, 0, 0)[k];
      high.add(u);
      const float scaled = u * 0x1p14f;
      low.add(scaled - std::floor(scaled));
    }
    expect_fit(high, "high bits of number " + std::to_string(k));
    expect_fit(low, "low bits of number " + std::to_string(k));
  }
}

TEST(RandomStatistics, NumbersOfABlockAreIndependent) {
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      Histogram pairs(48, 48);
      for (std::uint32_t i = 0; i < kCount; ++i) {
        const Block u = block_at(i, 0, 0, 0, 0, 7);
        pairs.add(u[a], u[b]);
      }
      expect_fit(pairs, "numbers " + std::to_string(a) + " and " + std::to_string(b));
    }
  }
}

struct Step {
  const char* name;
  std::uint32_t dx, dy, ds, dd;
  std::uint64_t seed;
};
constexpr Step kSteps[] = {
    {"next column", 1, 0, 0, 0, 0},       {"next row", 0, 1, 0, 0, 0},
    {"next sample", 0, 0, 1, 0, 0},       {"next dimension", 0, 0, 0, 1, 0},
    {"next seed", 0, 0, 0, 0, 1},         {"next tile", 32, 0, 0, 0, 0},
    {"far seed", 0, 0, 0, 0, 1ull << 32},
};

// Pairs of the same and of different numbers, and their serial correlation.
TEST(RandomStatistics, NeighboursAreIndependent) {
  for (const Step& s : kSteps) {
    for (std::size_t a = 0; a < 4; ++a) {
      Histogram same(32, 32), next(32, 32);
      double correlation = 0;
      for (std::uint32_t i = 0; i < kCount; ++i) {
        const Block here = block_at(i, 0, 0, 0, 0, 0);
        const Block there = block_at(i, s.dx, s.dy, s.ds, s.dd, s.seed);
        same.add(here[a], there[a]);
        next.add(here[a], there[(a + 1) % 4]);
        correlation += 12 * (double{here[a]} - 0.5) * (double{there[a]} - 0.5);
      }
      const std::string what = std::string(s.name) + ", number " + std::to_string(a);
      expect_fit(same, what);
      expect_fit(next, what + " against the next");
      const double z = correlation / std::sqrt(double{kCount});
      EXPECT_GT(test::normal_two_sided_tail(z), test::corrected_significance(kTests)) << what;
    }
  }
}

// Sums of a pixel's samples: over many pixels their variance must be that of independent numbers.
TEST(RandomStatistics, MeansOverSamplesHaveTheRightVariance) {
  constexpr std::uint32_t kPixels = 4096, kSamples = 64;
  for (std::size_t k = 0; k < 4; ++k) {
    double statistic = 0;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
      double sum = 0;
      for (std::uint32_t s = 0; s < kSamples; ++s) {
        sum += double{uniform4(pixel & 63, pixel >> 6, s, 0, 0)[k]} - 0.5;
      }
      statistic += sum * sum * 12 / kSamples;
    }
    const double upper = test::chi_squared_tail(statistic, kPixels);
    EXPECT_GT(2 * std::min(upper, 1 - upper), test::corrected_significance(kTests));
  }
}

TEST(RandomStatistics, DifferentCountersGiveDifferentBlocks) {
  for (std::uint32_t bit = 0; bit < 32; ++bit) {
    const std::uint32_t one = 1u << bit;
    const Block base = uniform4(5, 6, 7, 8, 9);
    EXPECT_NE(base, uniform4(5 ^ one, 6, 7, 8, 9));
    EXPECT_NE(base, uniform4(5, 6 ^ one, 7, 8, 9));
    EXPECT_NE(base, uniform4(5, 6, 7 ^ one, 8, 9));
    EXPECT_NE(base, uniform4(5, 6, 7, 8 ^ one, 9));
    EXPECT_NE(base, uniform4(5, 6, 7, 8, 9 ^ std::uint64_t{one}));
    EXPECT_NE(base, uniform4(5, 6, 7, 8, 9 ^ std::uint64_t{one} << 32));
  }
}

}  // namespace
}  // namespace dapple
