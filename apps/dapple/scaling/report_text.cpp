#include "dapple/scaling/report_text.h"

#include <fmt/format.h>

namespace dapple::scaling {
namespace {

std::string with_interval(const Estimate& e, int digits) {
  return fmt::format("{:.{}f} ({:.{}f}-{:.{}f})", e.value, digits, e.low, digits, e.high, digits);
}

std::string heading(const Curve& curve, const BaseWork& base) {
  std::string text = fmt::format("{}, {} scaling: ", work_name(curve.work), mode_name(curve.mode));
  if (curve.work == WorkKind::build) {
    text += fmt::format("spheres:{}", base.build_objects);
  } else {
    text += fmt::format("{}, {} x {} pixels, {} samples", base.scene, base.width, base.height,
                        curve.work == WorkKind::ray ? base.ray_samples : base.ray_bvh_samples);
  }
  if (curve.mode == Mode::weak) {
    text += fmt::format("; {} grow with the threads", growth_name(curve.work));
  }
  return text + "\n";
}

std::string fit_line(const Curve& curve) {
  if (!curve.serial_fraction) return "";
  const Estimate& s = *curve.serial_fraction;
  return fmt::format("  {}: serial fraction {:.2f} % ({:.2f} to {:.2f})\n",
                     curve.mode == Mode::strong ? "Amdahl's law" : "Gustafson's law", 100 * s.value,
                     100 * s.low, 100 * s.high);
}

}  // namespace

std::string to_text(const Result& result) {
  std::string text;
  for (const Curve& curve : result.curves) {
    if (!text.empty()) text += "\n";
    text += heading(curve, result.base);
    text += fmt::format("  {:>7}  {:<22}{:<19}{:<19}{:<19}{}\n", "threads", "seconds", "speed-up",
                        "efficiency", "imbalance", "efficiency by processor time");
    for (const Point& p : curve.points) {
      text += fmt::format("  {:>7}  {:<22}{:<19}{:<19}{:<19}{:.3f}{}\n", p.threads,
                          with_interval(p.seconds, 3), with_interval(p.speedup, 2),
                          with_interval(p.efficiency, 2), with_interval(p.imbalance, 2),
                          p.cpu_efficiency.value, p.oversubscribed ? "  more than cores" : "");
    }
    text += fit_line(curve);
  }
  return text;
}

}  // namespace dapple::scaling
