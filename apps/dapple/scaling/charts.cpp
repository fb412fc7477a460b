#include "dapple/scaling/charts.h"

#include <fmt/format.h>

#include "dapple/scaling/plot.h"

namespace dapple::scaling {
namespace {

using Figure = Estimate Point::*;
using Ideal = double (*)(const Curve& curve, double threads);

PlotPoint exactly(double x, double y) { return {x, {y, y, y}}; }

double ideal_speedup(const Curve&, double threads) { return threads; }
double one(const Curve&, double) { return 1; }
double ideal_seconds(const Curve& curve, double threads) {
  const double base = curve.points.front().seconds.value;
  return curve.mode == Mode::strong ? base / threads : base;
}

struct ChartKind {
  const char* name;
  const char* title;
  const char* y_label;
  Figure figure;
  Ideal ideal;
  bool ideal_is_shared;  // one line for all curves
};

PlotGuide ideal_line(const Curve& curve, const ChartKind& kind, const std::string& label) {
  PlotGuide guide{label, {}};
  const double last = curve.points.back().threads;
  constexpr int kSteps = 32;  // the ideal time is no straight line
  for (int i = 0; i <= kSteps; ++i) {
    const double threads = 1 + (last - 1) * i / kSteps;
    guide.points.push_back(exactly(threads, kind.ideal(curve, threads)));
  }
  return guide;
}

std::string series_label(const Curve& curve, bool with_fit) {
  const std::string name(work_name(curve.work));
  if (!with_fit || !curve.serial_fraction) return name;
  return fmt::format("{}: serial fraction {:.1f} %", name, 100 * curve.serial_fraction->value);
}

std::string note_of(const Result& result) {
  const int most = result.measurements.threads.back();
  if (most > result.machine.cores) {
    return fmt::format("Warning: {} threads on {} cores; grey: more threads than cores", most,
                       result.machine.cores);
  }
  return result.warnings.empty() ? "" : "Warning: " + result.warnings.front().substr(0, 80);
}

Chart make_chart(const Result& result, Mode mode, const ChartKind& kind) {
  Plot plot;
  plot.title = fmt::format("{}, {} scaling", kind.title, mode_name(mode));
  plot.x_label = "threads";
  plot.y_label = kind.y_label;
  plot.note = note_of(result);
  plot.doubtful_from = result.machine.cores;
  for (const Curve& curve : result.curves) {
    if (curve.mode != mode) continue;
    PlotSeries series{series_label(curve, kind.figure == &Point::speedup), {}};
    for (const Point& p : curve.points) {
      series.points.push_back({static_cast<double>(p.threads), p.*kind.figure});
    }
    if (!kind.ideal_is_shared || plot.series.empty()) {
      plot.guides.push_back(ideal_line(curve, kind, plot.series.empty() ? "ideal" : ""));
    }
    plot.series.push_back(std::move(series));
  }
  return {fmt::format("{}-{}.svg", mode_name(mode), kind.name), to_svg(plot)};
}

}  // namespace

std::vector<Chart> make_charts(const Result& result) {
  const ChartKind kinds[] = {
      {"time", "Time", "seconds", &Point::seconds, ideal_seconds, false},
      {"speedup", "Speed-up", "times one thread", &Point::speedup, ideal_speedup, true},
      {"efficiency", "Efficiency", "speed-up / threads", &Point::efficiency, one, true},
      {"imbalance", "Load imbalance", "longest / mean busy time", &Point::imbalance, one, true},
  };
  std::vector<Chart> charts;
  for (const Mode mode : {Mode::strong, Mode::weak}) {
    for (const ChartKind& kind : kinds) charts.push_back(make_chart(result, mode, kind));
  }
  return charts;
}

}  // namespace dapple::scaling
