#include "dapple/scaling/json.h"

#include <nlohmann/json.hpp>

namespace dapple::scaling {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const Estimate& e) {
  return {{"value", e.value}, {"low", e.low}, {"high", e.high}};
}

ordered_json to_json(const BaseWork& base) {
  return {{"scene", base.scene},
          {"width", base.width},
          {"height", base.height},
          {"ray_samples", base.ray_samples},
          {"ray_bvh_samples", base.ray_bvh_samples},
          {"build_objects", base.build_objects}};
}

ordered_json to_json(const Machine& m) {
  return {{"processor", m.processor},
          {"cores", m.cores},
          {"cores_online", m.cores_online},
          {"memory_gib", m.memory_gib},
          {"system", m.system},
          {"isa", m.isa},
          {"load_before", m.load_before},
          {"load_after", m.load_after},
          {"other_cores", m.activity.other_cores},
          {"stolen_cores", m.activity.stolen_cores}};
}

ordered_json to_json(const Point& p) {
  return {{"threads", p.threads},
          {"oversubscribed", p.oversubscribed},
          {"noisy", p.seconds.uncertainty() > kNoisy},
          {"seconds", to_json(p.seconds)},
          {"speedup", to_json(p.speedup)},
          {"efficiency", to_json(p.efficiency)},
          {"imbalance", to_json(p.imbalance)},
          {"cpu_seconds", to_json(p.cpu_seconds)},
          {"cpu_efficiency", to_json(p.cpu_efficiency)}};
}

ordered_json to_json(const Curve& curve) {
  const bool strong = curve.mode == Mode::strong;
  ordered_json points = ordered_json::array();
  for (const Point& point : curve.points) points.push_back(to_json(point));
  ordered_json json = {{"work", work_name(curve.work)}, {"mode", mode_name(curve.mode)}};
  if (!strong) json["grows"] = growth_name(curve.work);
  json["law"] = strong ? "Amdahl" : "Gustafson";
  json["serial_fraction"] =
      curve.serial_fraction ? to_json(*curve.serial_fraction) : ordered_json(nullptr);
  json["points"] = std::move(points);
  return json;
}

ordered_json to_json(const Configuration& c, const std::vector<Sample>& samples) {
  ordered_json runs = ordered_json::array();
  for (const Sample& sample : samples) {
    ordered_json busy = ordered_json::array();
    for (const BusyTime& thread : sample.busy) {
      busy.push_back({{"wall", thread.wall}, {"cpu", thread.cpu}, {"pieces", thread.pieces}});
    }
    runs.push_back({{"wall", sample.wall},
                    {"cpu", sample.cpu},
                    {"other_cores", sample.activity.cores()},
                    {"busy", std::move(busy)}});
  }
  return {{"work", work_name(c.work)},
          {"threads", c.threads},
          {"factor", c.factor},
          {"runs", std::move(runs)}};
}

}  // namespace

std::string to_json_text(const Result& result) {
  const Measurements& m = result.measurements;
  ordered_json json = {{"base", to_json(result.base)},
                       {"machine", to_json(result.machine)},
                       {"pinned", m.pinned},
                       {"rounds", m.rounds},
                       {"repeated", m.repeated},
                       {"warnings", result.warnings},
                       {"curves", ordered_json::array()},
                       {"measurements", ordered_json::array()}};
  for (const Curve& curve : result.curves) json["curves"].push_back(to_json(curve));
  for (std::size_t i = 0; i < m.plan.size(); ++i) {
    json["measurements"].push_back(to_json(m.plan[i], m.samples[i]));
  }
  // File names need not be UTF-8.
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace dapple::scaling
