// Repeated measurements of one thing, and what may be said of them.
#pragma once

#include <string>
#include <vector>

#include "harness/cores.h"
#include "harness/stopwatch.h"

namespace dapple::bench {

struct Samples {
  std::string name;
  Cores cores = Cores::all;
  std::vector<Seconds> runs;

  // Wall time on all cores. On one pinned core processor time: what other processes take of that
  // core does not count, and a second thread that was not meant to be there would.
  std::vector<double> seconds() const;
  double median() const;
  // (max - min) / median: how noisy the machine is.
  double spread() const;
};

[[nodiscard]] double median_of(std::vector<double> values);

// How many times as long `slow` took as `fast`: the medians' ratio, and the lowest and highest of
// the ratios of runs of the same round.
struct Ratio {
  double median = 0, low = 0, high = 0;
};
[[nodiscard]] Ratio time_ratio(const Samples& slow, const Samples& fast);

// Above this spread a result is marked as noisy.
inline constexpr double kNoisySpread = 0.10;

}  // namespace dapple::bench
