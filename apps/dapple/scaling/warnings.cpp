#include <fmt/format.h>

#include "dapple/scaling/summary.h"

namespace dapple::scaling {
namespace {

constexpr double kOtherCores = 0.05;  // of which more disturbs
constexpr int kFewRounds = 5;

class Warnings {
 public:
  template <class... Args>
  void add(bool holds, fmt::format_string<Args...> format, Args&&... args) {
    if (holds) list_.push_back(fmt::format(format, std::forward<Args>(args)...));
  }
  std::vector<std::string> take() { return std::move(list_); }

 private:
  std::vector<std::string> list_;
};

struct Noise {
  int points = 0, noisy = 0;
  double worst = 0;
  std::string where;
};

Noise find_noise(const std::vector<Curve>& curves) {
  Noise noise;
  for (const Curve& curve : curves) {
    for (const Point& point : curve.points) {
      const double uncertainty = point.seconds.uncertainty();
      ++noise.points;
      if (uncertainty > kNoisy) ++noise.noisy;
      if (uncertainty <= noise.worst) continue;
      noise.worst = uncertainty;
      noise.where = fmt::format("{} ({} scaling) on {} threads", work_name(curve.work),
                                mode_name(curve.mode), point.threads);
    }
  }
  return noise;
}

}  // namespace

std::vector<std::string> find_warnings(const std::vector<Curve>& curves,
                                       const Measurements& measurements, const Machine& machine,
                                       bool pin_wanted) {
  Warnings warnings;
  const int most = measurements.threads.back();
  warnings.add(most > machine.cores,
               "{} threads on {} cores: points with more threads than cores say nothing about "
               "more cores, and no law is fitted to them",
               most, machine.cores);
  warnings.add(machine.cores == 1 || most == 1,
               "one thread alone: there is nothing to fit a law to");
  warnings.add(pin_wanted && !measurements.pinned,
               "the system did not let threads be tied to cores");
  warnings.add(measurements.rounds < kFewRounds,
               "{} repetitions are too few for confidence intervals of 95 %; take {} at least",
               measurements.rounds, kFewRounds);
  const Noise noise = find_noise(curves);
  warnings.add(noise.noisy > 0,
               "{} of {} times are uncertain by more than {:.0f} %, {} by {:.0f} %: the machine is "
               "too noisy, or the runs are too short or too few",
               noise.noisy, noise.points, 100 * kNoisy, noise.where, 100 * noise.worst);
  warnings.add(machine.activity.other_cores > kOtherCores,
               "other programs kept {:.2f} cores busy meanwhile", machine.activity.other_cores);
  warnings.add(machine.activity.stolen_cores > kOtherCores,
               "the host took {:.2f} cores of this virtual machine away meanwhile",
               machine.activity.stolen_cores);
  return warnings.take();
}

}  // namespace dapple::scaling
