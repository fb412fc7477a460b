#include "kernels/kernel_bench.h"

#include <fmt/format.h>

#include "harness/interleave.h"
#include "kernels/agreement.h"

namespace dapple::bench {
namespace {

// A build of more objects than this takes so long that what the first one has to set up does not
// show.
constexpr std::size_t kWarmBuilds = 2'000'000;

double million_per_second(std::size_t count, const Samples& samples) {
  return 1e-6 * static_cast<double>(count) / samples.median();
}

// The fastest of a contender's ways.
const Samples& best_of(std::span<const Samples> samples) {
  return *std::min_element(samples.begin(), samples.end(),
                           [](const auto& a, const auto& b) { return a.median() < b.median(); });
}

struct Lap {
  std::size_t contender;
  std::unique_ptr<Tracer> tracer;
};

std::vector<Lap> all_ways(const Contenders& contenders, const RaySet& set) {
  std::vector<Lap> laps;
  for (std::size_t c = 0; c < contenders.size(); ++c) {
    for (auto& tracer : contenders[c]->tracers(set.rays, set.query)) {
      laps.push_back({c, std::move(tracer)});
    }
  }
  return laps;
}

// How many times as fast the first contender's best way is as the best of all others.
Ratio ratio_to_others(std::span<const Samples> samples, std::size_t own_ways) {
  return time_ratio(best_of(samples.subspan(own_ways)), best_of(samples.first(own_ways)));
}

FindHits finder(const Contender& contender) {
  return [&](std::span<const Ray> rays) { return trace_once(contender, rays, Query::closest); };
}

Agreement agreement(const SceneView& scene, const RaySet& set, std::span<const Found> own,
                    const Contender& owner, const Tracer& tracer, const Contender& other) {
  return set.query == Query::closest
             ? compare_closest(scene, set.rays, own, tracer.found())
             : compare_any(scene, set.rays, own, tracer.found(), finder(owner), finder(other));
}

}  // namespace

void compare_builds(const std::string& scene_name, const SceneView& scene,
                    const Contenders& contenders, Cores cores, int rounds, Report& report) {
  std::vector<Task> tasks;
  for (const auto& contender : contenders) {
    tasks.push_back({contender->name(), [&] { contender->discard(); },
                     [&] { contender->build(scene); }, cores});
  }
  const auto samples = run_interleaved(
      tasks, rounds, scene.object_count() <= kWarmBuilds ? WarmUp::one_round : WarmUp::none);
  const auto objects = static_cast<double>(scene.object_count());
  Table table({"build", "seconds", "million/s", "bytes/object", "SAH cost"});
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const Contender& contender = *contenders[i];
    const double bytes = static_cast<double>(contender.bytes()) / objects;
    table.add_row({contender.name(), fmt::format("{:.3f}", samples[i].median()),
                   fmt::format("{:.2f}", million_per_second(scene.object_count(), samples[i])),
                   fmt::format("{:.1f}", bytes),
                   contender.sah_cost() > 0 ? fmt::format("{:.2f}", contender.sah_cost()) : "-"});
    nlohmann::json row = to_json(samples[i]);
    row["scene"] = scene_name;
    row["cores"] = cores_name(cores);
    row["objects"] = scene.object_count();
    row["bytes_per_object"] = bytes;
    row["sah_cost"] = contender.sah_cost();
    report.add("build", std::move(row));
    report.check_noise(
        fmt::format("{}, {} build, {}", scene_name, contender.name(), cores_name(cores)),
        samples[i]);
  }
  report.print(fmt::format("{}, {}", scene_name, cores_name(cores)), table);
}

void compare_tracing(const std::string& scene_name, const std::vector<RaySet>& sets,
                     const Contenders& contenders, Cores cores, int rounds, Report& report) {
  for (const RaySet& set : sets) {
    const std::vector<Lap> laps = all_ways(contenders, set);
    std::vector<Task> tasks;
    std::size_t own_ways = 0;
    for (const Lap& lap : laps) {
      own_ways += lap.contender == 0;
      tasks.push_back(
          {lap.tracer->name(), [&] { lap.tracer->reset(); }, [&] { lap.tracer->trace(); }, cores});
    }
    const auto samples = run_interleaved(tasks, rounds, WarmUp::one_round);
    Table table({"million rays/s", "median", "spread"});
    nlohmann::json row{{"scene", scene_name},
                       {"cores", cores_name(cores)},
                       {"rays", set.name},
                       {"count", set.rays.size()}};
    for (const Samples& way : samples) {
      const double rate = million_per_second(set.rays.size(), way);
      table.add_row(
          {way.name, fmt::format("{:.3f}", rate), fmt::format("{:.0f} %", 100 * way.spread())});
      nlohmann::json details = to_json(way);
      details["million_per_second"] = rate;
      row["ways"].push_back(std::move(details));
      report.check_noise(
          fmt::format("{}, {}, {}, {}", scene_name, set.name, way.name, cores_name(cores)), way);
    }
    std::string title = fmt::format("{}, {} rays, {}", scene_name, set.name, cores_name(cores));
    if (own_ways < samples.size()) {
      const Ratio ratio = ratio_to_others(samples, own_ways);
      row["ratio"] = to_json(ratio);
      row["best_other"] = best_of(std::span(samples).subspan(own_ways)).name;
      title += fmt::format(": {} times {}", to_text(ratio), row["best_other"].get<std::string>());
    }
    report.add("tracing", std::move(row));
    report.print(title, table);
  }
}

void compare_hits(const std::string& scene_name, const SceneView& scene,
                  const std::vector<RaySet>& sets, const Contenders& contenders, Report& report) {
  if (contenders.size() < 2) return;
  Table table({"hits compared", "way", "same", "borderline", contenders[0]->name() + " wrong",
               "other wrong"});
  for (const RaySet& set : sets) {
    const std::vector<Found> own = trace_once(*contenders[0], set.rays, set.query);
    for (const Lap& lap : all_ways(contenders, set)) {
      if (lap.contender == 0) continue;
      lap.tracer->reset();
      lap.tracer->trace();
      const Agreement result =
          agreement(scene, set, own, *contenders[0], *lap.tracer, *contenders[lap.contender]);
      table.add_row({set.name, lap.tracer->name(), fmt::to_string(result.same),
                     fmt::to_string(result.borderline), fmt::to_string(result.a_wrong),
                     fmt::to_string(result.b_wrong)});
      report.add("hits", {{"scene", scene_name},
                          {"rays", set.name},
                          {"way", lap.tracer->name()},
                          {"same", result.same},
                          {"borderline", result.borderline},
                          {"own_wrong", result.a_wrong},
                          {"other_wrong", result.b_wrong}});
      if (result.a_wrong > 0) {
        report.warn(fmt::format("{}, {}: {} hits that double precision contradicts", scene_name,
                                set.name, result.a_wrong));
      }
    }
  }
  report.print(scene_name, table);
}

}  // namespace dapple::bench
