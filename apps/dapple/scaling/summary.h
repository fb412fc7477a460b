// From runs to curves: times, speed-ups, efficiencies, load balance and the fitted laws.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dapple/scaling/bootstrap.h"
#include "dapple/scaling/machine.h"
#include "dapple/scaling/study.h"

namespace dapple::scaling {

struct Point {
  int threads = 1;
  Estimate seconds;  // wall time, median of the rounds
  // Strong: T(1) / T(n); weak: n T(1) / T(n), for n times the work. The median of the rounds' own
  // ratios, as the speed of many machines drifts.
  Estimate speedup;
  Estimate efficiency;  // the speed-up over n
  Estimate imbalance;   // longest busy time of a thread over the mean
  Estimate cpu_seconds;
  // Processor time of one thread for the same work over that of all: 1 when sharing out costs
  // nothing. Other load on the machine hardly changes it; threads that sleep do not show in it.
  Estimate cpu_efficiency;
  bool oversubscribed = false;  // more threads than cores: not in the fit
};

struct Curve {
  WorkKind work = WorkKind::ray;
  Mode mode = Mode::strong;
  std::vector<Point> points;
  // Of Amdahl's law for strong and Gustafson's for weak scaling.
  std::optional<Estimate> serial_fraction;
};

// A time whose interval is wider than this on either side is called noisy.
inline constexpr double kNoisy = 0.05;

[[nodiscard]] std::vector<Curve> make_curves(const Measurements& measurements, int cores);

// What a reader must know before believing the figures.
[[nodiscard]] std::vector<std::string> find_warnings(const std::vector<Curve>& curves,
                                                     const Measurements& measurements,
                                                     const Machine& machine, bool pin_wanted);

// The law's speed-up for the fitted serial fraction, which there must be.
[[nodiscard]] double fitted_speedup(const Curve& curve, double threads);

}  // namespace dapple::scaling
