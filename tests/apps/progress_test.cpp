// The words of the progress bar.
#include "dapple/progress_bar.h"

#include <gtest/gtest.h>

namespace dapple {
namespace {

TEST(ProgressLine, ShowsShareRateAndTimeLeft) {
  EXPECT_EQ(progress_line({0.42, 3.42e6, 65}, 60),
            " 42% [==========>              ] 3.42 M samples/s, 1:05 left");
}

TEST(ProgressLine, FitsIntoAnyWidth) {
  for (std::size_t columns = 0; columns < 200; ++columns) {
    for (const double fraction : {0.0, 0.001, 0.5, 0.999, 1.0, 1.5}) {
      const std::string line = progress_line({fraction, 1.5e9, 1e6}, columns);
      EXPECT_LE(line.size(), columns);
      EXPECT_EQ(line.find('\n'), std::string::npos);
    }
  }
}

TEST(ProgressLine, TheBarGrows) {
  std::size_t last = 0;
  for (int percent = 0; percent <= 100; ++percent) {
    const std::string line = progress_line({percent / 100.0, 1e6, 10}, 79);
    const auto filled = static_cast<std::size_t>(std::count(line.begin(), line.end(), '='));
    EXPECT_GE(filled, last);
    last = filled;
  }
  EXPECT_EQ(progress_line({1, 1e6, 0}, 79).find('>'), std::string::npos);
}

TEST(DurationText, CountsMinutesAndHours) {
  EXPECT_EQ(duration_text(0), "0:00");
  EXPECT_EQ(duration_text(59.4), "0:59");
  EXPECT_EQ(duration_text(59.6), "1:00");
  EXPECT_EQ(duration_text(3599), "59:59");
  EXPECT_EQ(duration_text(7207), "2:00:07");
  EXPECT_EQ(duration_text(-1), "0:00");
}

TEST(ScaledText, HasThreeDigits) {
  EXPECT_EQ(scaled_text(0), "0");
  EXPECT_EQ(scaled_text(950), "950");
  EXPECT_EQ(scaled_text(999.9), "1.00 k");
  EXPECT_EQ(scaled_text(12345), "12.3 k");
  EXPECT_EQ(scaled_text(999'600), "1.00 M");
  EXPECT_EQ(scaled_text(123.4e6), "123 M");
  EXPECT_EQ(scaled_text(2.5e12), "2500 G");
}

}  // namespace
}  // namespace dapple
