#include "image/transfer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dapple {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// The curves of the standards, by the mathematical library in extended precision.
long double exact_encode(long double x, Transfer transfer) {
  if (transfer == Transfer::gamma2) return std::sqrt(x);
  return x <= 0.0031308L ? 12.92L * x : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L;
}

long double exact_decode(long double x, Transfer transfer) {
  if (transfer == Transfer::gamma2) return x * x;
  return x <= 0.04045L ? x / 12.92L : std::pow((x + 0.055L) / 1.055L, 2.4L);
}

std::uint32_t exact_integer(float x, Transfer transfer, std::uint32_t max) {
  return static_cast<std::uint32_t>(std::floor(exact_encode(x, transfer) * max + 0.5L));
}

class TransferTest : public testing::TestWithParam<Transfer> {};

// The nearest integer can only go wrong at the floats around the places where it changes.
TEST_P(TransferTest, EveryThresholdIsRoundedToTheNearestInteger) {
  for (const std::uint32_t max : {255u, 65535u}) {
    for (std::uint32_t i = 1; i <= max; ++i) {
      auto x = static_cast<float>(exact_decode((i - 0.5L) / max, GetParam()));
      for (int step = 0; step < 4; ++step) x = std::nextafter(x, 0.0f);
      for (int step = 0; step < 9; ++step, x = std::nextafter(x, 2.0f)) {
        ASSERT_EQ(encode_integer(x, GetParam(), max), exact_integer(x, GetParam(), max)) << x;
      }
    }
  }
}

TEST_P(TransferTest, DecodingMatchesTheExactCurve) {
  for (int i = 0; i <= 100'003; ++i) {
    const double display = i / 100'003.0;
    const auto exact = static_cast<double>(exact_decode(display, GetParam()));
    ASSERT_NEAR(decode_display(display, GetParam()), exact, 1e-14 * exact) << display;
  }
}

TEST_P(TransferTest, DecodedIntegersEncodeToThemselvesAndGrow) {
  for (const std::uint32_t max : {1u, 255u, 1000u, 65535u}) {
    const std::vector<float> table = decode_table(max, GetParam());
    ASSERT_EQ(table.size(), max + 1);
    EXPECT_EQ(table.front(), 0.0f);
    EXPECT_EQ(table.back(), 1.0f);
    for (std::uint32_t i = 0; i <= max; ++i) {
      ASSERT_EQ(encode_integer(table[i], GetParam(), max), i);
      ASSERT_TRUE(i == 0 || table[i] > table[i - 1]) << i;
    }
  }
}

TEST_P(TransferTest, EncodingNeverDecreases) {
  double before = 0;
  for (float x = 0x1p-24f; x <= 1.0f; x *= 1.00001f) {
    const double display = encode_display(x, GetParam());
    ASSERT_GE(display, before) << x;
    ASSERT_LE(display, 1.0) << x;
    before = display;
  }
}

TEST_P(TransferTest, ValuesOutsideTheUnitRangeAreDefined) {
  for (const std::uint32_t max : {255u, 65535u}) {
    for (const float x : {0.0f, -0.0f, -1e-30f, -1.0f, -kInfinity, kNan, -kNan}) {
      EXPECT_EQ(encode_integer(x, GetParam(), max), 0u) << x;
    }
    for (const float x : {1.0f, 1.0001f, 1e30f, kInfinity}) {
      EXPECT_EQ(encode_integer(x, GetParam(), max), max) << x;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Curves, TransferTest, testing::Values(Transfer::srgb, Transfer::gamma2),
                         [](const auto& test) {
                           return test.param == Transfer::srgb ? "srgb" : "gamma2";
                         });

TEST(DecodeTable, AnyGammaMatchesTheMathematicalLibrary) {
  for (const double gamma : {0.45455, 0.5, 1.0, 1 / 1.8, 2.2}) {
    const std::vector<float> table = decode_table(255, gamma);
    for (std::size_t i = 0; i < 256; ++i) {
      const double exact = std::pow(static_cast<double>(i) / 255, 1 / gamma);
      ASSERT_NEAR(table[i], exact, 1e-7 * exact) << gamma;
    }
  }
}

}  // namespace
}  // namespace dapple
