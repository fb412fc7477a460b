#include "util/parse_number.h"

#include <gtest/gtest.h>

#include <limits>

namespace dapple {
namespace {

constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kHighest = std::numeric_limits<std::int64_t>::max();

TEST(ParseInteger, WholeNumbersInRange) {
  EXPECT_EQ(parse_integer("1", "NX", 1, 10), 1);
  EXPECT_EQ(parse_integer("10", "NX", 1, 10), 10);
  EXPECT_EQ(parse_integer("007", "NX", 1, 10), 7);
  EXPECT_EQ(parse_integer("-3", "NX", -5, 5), -3);
  EXPECT_EQ(parse_integer("9223372036854775807", "NX", kLowest, kHighest), kHighest);
  EXPECT_EQ(parse_integer("-9223372036854775808", "NX", kLowest, kHighest), kLowest);
}

TEST(ParseInteger, EverythingElseIsAUsageErrorThatNamesTheArgument) {
  for (const char* text : {"",
                           " ",
                           "12x",
                           "x12",
                           "1e9",
                           "+3",
                           " 7",
                           "7 ",
                           "1.0",
                           "0x10",
                           "--1",
                           "-",
                           "0",
                           "-3",
                           "1001",
                           "99999999999",
                           "99999999999999999999",
                           "-99999999999999999999",
                           "99999999999999999999x",
                           "1\n"}) {
    const auto value = parse_integer(text, "NX", 1, 1000);
    ASSERT_FALSE(value) << text;
    EXPECT_EQ(value.error().code, Errc::usage) << text;
    EXPECT_EQ(value.error().place, "NX");
    EXPECT_NE(value.error().message.find(text), std::string::npos);
  }
}

}  // namespace
}  // namespace dapple
