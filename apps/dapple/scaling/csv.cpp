#include "dapple/scaling/csv.h"

#include <fmt/format.h>

namespace dapple::scaling {
namespace {

std::string with_interval(const Estimate& e) {
  return fmt::format("{:.6g},{:.6g},{:.6g}", e.value, e.low, e.high);
}

std::string interval_header(std::string_view name) {
  return fmt::format("{0},{0}_low,{0}_high", name);
}

int yes(bool value) { return value ? 1 : 0; }

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

std::string points_csv(const Result& result) {
  std::string text = fmt::format("work,mode,threads,{},{},{},{},{},{},oversubscribed,noisy\n",
                                 interval_header("seconds"), interval_header("speedup"),
                                 interval_header("efficiency"), interval_header("imbalance"),
                                 interval_header("cpu_seconds"), interval_header("cpu_efficiency"));
  for (const Curve& curve : result.curves) {
    for (const Point& p : curve.points) {
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", work_name(curve.work),
                          mode_name(curve.mode), p.threads, with_interval(p.seconds),
                          with_interval(p.speedup), with_interval(p.efficiency),
                          with_interval(p.imbalance), with_interval(p.cpu_seconds),
                          with_interval(p.cpu_efficiency), yes(p.oversubscribed),
                          yes(p.seconds.uncertainty() > kNoisy));
    }
  }
  return text;
}

std::string fits_csv(const Result& result) {
  std::string text = fmt::format("work,mode,law,grows,{}\n", interval_header("serial_fraction"));
  for (const Curve& curve : result.curves) {
    if (!curve.serial_fraction) continue;
    const bool strong = curve.mode == Mode::strong;
    text +=
        fmt::format("{},{},{},{},{}\n", work_name(curve.work), mode_name(curve.mode),
                    strong ? "Amdahl" : "Gustafson", strong ? "nothing" : growth_name(curve.work),
                    with_interval(*curve.serial_fraction));
  }
  return text;
}

std::string threads_csv(const Result& result) {
  std::string text =
      "work,threads,factor,round,wall,cpu,other_cores,thread,busy_wall,busy_cpu,pieces\n";
  const Measurements& m = result.measurements;
  for (std::size_t i = 0; i < m.plan.size(); ++i) {
    const Configuration& c = m.plan[i];
    for (std::size_t round = 0; round < m.samples[i].size(); ++round) {
      const Sample& sample = m.samples[i][round];
      for (std::size_t thread = 0; thread < sample.busy.size(); ++thread) {
        const BusyTime& busy = sample.busy[thread];
        text += fmt::format("{},{},{},{},{:.6f},{:.6f},{:.3f},{},{:.6f},{:.6f},{}\n",
                            work_name(c.work), c.threads, c.factor, round, sample.wall, sample.cpu,
                            sample.activity.cores(), thread, busy.wall, busy.cpu, busy.pieces);
      }
    }
  }
  return text;
}

std::string machine_csv(const Result& result) {
  const Machine& m = result.machine;
  std::string text = "key,value\n";
  const auto add = [&](std::string_view key, const std::string& value) {
    text += fmt::format("{},{}\n", key, quoted(value));
  };
  add("processor", m.processor);
  add("cores", fmt::format("{}", m.cores));
  add("cores_online", fmt::format("{}", m.cores_online));
  add("memory_gib", fmt::format("{:.1f}", m.memory_gib));
  add("system", m.system);
  add("isa", m.isa);
  add("load_before", fmt::format("{:.2f}", m.load_before));
  add("load_after", fmt::format("{:.2f}", m.load_after));
  add("other_cores", fmt::format("{:.3f}", m.activity.other_cores));
  add("stolen_cores", fmt::format("{:.3f}", m.activity.stolen_cores));
  add("pinned", fmt::format("{}", yes(result.measurements.pinned)));
  add("rounds", fmt::format("{}", result.measurements.rounds));
  add("repeated", fmt::format("{}", result.measurements.repeated));
  add("scene", result.base.scene);
  add("width", fmt::format("{}", result.base.width));
  add("height", fmt::format("{}", result.base.height));
  add("ray_samples", fmt::format("{}", result.base.ray_samples));
  add("ray_bvh_samples", fmt::format("{}", result.base.ray_bvh_samples));
  add("build_objects", fmt::format("{}", result.base.build_objects));
  for (const std::string& warning : result.warnings) add("warning", warning);
  return text;
}

}  // namespace dapple::scaling
