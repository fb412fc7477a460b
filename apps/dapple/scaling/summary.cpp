#include "dapple/scaling/summary.h"

#include <algorithm>

#include "dapple/scaling/laws.h"

namespace dapple::scaling {
namespace {

// The runs of one configuration.
using Runs = std::vector<Sample>;

constexpr std::size_t kFiguresPerPoint = 6;

// The figures of a curve as one list, computed from any choice of rounds: for each point those of
// Point in their order, and the serial fraction at the end.
class CurveStatistic {
 public:
  CurveStatistic(const Measurements& measurements, WorkKind work, Mode mode, int cores)
      : mode_(mode), cores_(cores) {
    for (const int threads : measurements.threads) {
      const auto place = std::find(measurements.plan.begin(), measurements.plan.end(),
                                   configuration_of(work, mode, threads));
      points_.push_back(
          {threads,
           &measurements.samples[static_cast<std::size_t>(place - measurements.plan.begin())]});
    }
  }

  std::vector<double> operator()(std::span<const std::size_t> rounds) const {
    std::vector<double> figures;
    const Runs& one = *points_[0].runs;
    std::vector<SpeedupPoint> in_fit;
    for (const auto& [threads, runs] : points_) {
      const double work = mode_ == Mode::strong ? 1 : threads;
      const double speedup = work * median_ratio(one, *runs, rounds, &wall);
      figures.insert(figures.end(),
                     {median_of(*runs, rounds, &wall), speedup, speedup / threads,
                      median_of(*runs, rounds, &imbalance), median_of(*runs, rounds, &cpu),
                      work * median_ratio(one, *runs, rounds, &cpu)});
      if (threads <= cores_) in_fit.push_back({static_cast<double>(threads), speedup});
    }
    const auto serial = mode_ == Mode::strong ? fit_amdahl(in_fit) : fit_gustafson(in_fit);
    has_fit_ = serial.has_value();
    figures.push_back(serial.value_or(0));
    return figures;
  }

  bool has_fit() const { return has_fit_; }

 private:
  struct PointRuns {
    int threads;
    const Runs* runs;
  };

  static double wall(const Sample& sample) { return sample.wall; }
  static double cpu(const Sample& sample) { return sample.cpu; }
  static double imbalance(const Sample& sample) { return sample.imbalance(); }

  static double median_of(const Runs& runs, std::span<const std::size_t> rounds,
                          double (*figure)(const Sample&)) {
    std::vector<double> values;
    for (const std::size_t round : rounds) values.push_back(figure(runs[round]));
    return median(std::move(values));
  }

  // Of runs of the same round: what the machine's speed was in that round cancels out.
  static double median_ratio(const Runs& above, const Runs& below,
                             std::span<const std::size_t> rounds, double (*figure)(const Sample&)) {
    std::vector<double> ratios;
    for (const std::size_t round : rounds) {
      ratios.push_back(figure(above[round]) / figure(below[round]));
    }
    return median(std::move(ratios));
  }

  Mode mode_;
  int cores_;
  std::vector<PointRuns> points_;
  mutable bool has_fit_ = false;
};

Curve make_curve(const Measurements& measurements, WorkKind work, Mode mode, int cores) {
  const CurveStatistic statistic(measurements, work, mode, cores);
  const std::vector<Estimate> figures =
      bootstrap(static_cast<std::size_t>(measurements.rounds), std::cref(statistic));
  Curve curve{work, mode, {}, {}};
  for (std::size_t i = 0; i < measurements.threads.size(); ++i) {
    const Estimate* f = &figures[i * kFiguresPerPoint];
    const int threads = measurements.threads[i];
    curve.points.push_back({threads, f[0], f[1], f[2], f[3], f[4], f[5], threads > cores});
  }
  if (statistic.has_fit()) curve.serial_fraction = figures.back();
  return curve;
}

}  // namespace

std::vector<Curve> make_curves(const Measurements& measurements, int cores) {
  std::vector<Curve> curves;
  std::vector<WorkKind> seen;
  for (const Configuration& configuration : measurements.plan) {
    const WorkKind work = configuration.work;
    if (std::find(seen.begin(), seen.end(), work) != seen.end()) continue;
    seen.push_back(work);
    for (const Mode mode : {Mode::strong, Mode::weak}) {
      curves.push_back(make_curve(measurements, work, mode, cores));
    }
  }
  return curves;
}

double fitted_speedup(const Curve& curve, double threads) {
  const double serial = curve.serial_fraction.value().value;
  return curve.mode == Mode::strong ? amdahl_speedup(serial, threads)
                                    : gustafson_speedup(serial, threads);
}

}  // namespace dapple::scaling
