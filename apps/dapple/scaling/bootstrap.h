// Confidence intervals of anything that is computed from repeated rounds of measurements.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace dapple::scaling {

// A figure with its 95 % confidence interval.
struct Estimate {
  double value = 0, low = 0, high = 0;

  // Half the interval's width, as a part of the value.
  double uncertainty() const { return value == 0 ? 0 : (high - low) / 2 / value; }
};

// The middle value, or the mean of the two middles; not for an empty list.
[[nodiscard]] double median(std::vector<double> values);
// The value below which a part `p` of the list lies, interpolated; not for an empty list.
[[nodiscard]] double percentile(std::vector<double> values, double p);

// Figures as a function of some rounds, given by their numbers, which may occur more than once.
using RoundStatistic = std::function<std::vector<double>(std::span<const std::size_t> rounds)>;

// The percentile bootstrap [EfronTibshirani93]: as many rounds as were measured are drawn with
// replacement, again and again, and the figures computed anew; the interval holds the middle 95 %.
// Whole rounds are drawn, so that what met all runs of a round alike cancels out of their ratios.
// The draws are the same every time.
[[nodiscard]] std::vector<Estimate> bootstrap(std::size_t round_count,
                                              const RoundStatistic& statistic);

}  // namespace dapple::scaling
