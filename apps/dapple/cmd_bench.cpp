#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "accel/kernels/dispatch.h"
#include "common/clock.h"
#include "common/standard_output.h"
#include "common/stop_signal.h"
#include "dapple/bench_rays.h"
#include "dapple/commands.h"
#include "dapple/common_options.h"
#include "dapple/progress_bar.h"
#include "parallel/parallel.h"

namespace dapple {
namespace {

constexpr std::size_t kBlockSize = 4096;  // rays in one call, as a renderer's batches

// Rays a second; 0 when there were no rays.
struct RayRates {
  std::size_t ray_count = 0;
  double closest_hit = 0;
  double any_hit = 0;
};

struct Figures {
  AccelKind kind;
  double build_seconds = 0;
  AccelStats stats;
  RayRates coherent, incoherent;
};

struct BenchSettings {
  RenderSettings camera;
  int repeat = 1;
  BvhQuality bvh_quality = BvhQuality::medium;
  LeafForm leaf_form = LeafForm::whole;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <class Work>
double median_seconds(int repeat, Work&& work) {
  std::vector<double> seconds;
  for (int i = 0; i < repeat; ++i) {
    const Clock clock;
    work();
    seconds.push_back(clock.seconds());
    if (!check_stop()) break;
  }
  return median(std::move(seconds));
}

// Calls trace(begin, length) for blocks of rays, in parallel.
template <class Trace>
void for_blocks(std::size_t count, Trace&& trace) {
  parallel_for_dynamic((count + kBlockSize - 1) / kBlockSize, [&](std::size_t block) {
    const std::size_t begin = block * kBlockSize;
    trace(begin, std::min(kBlockSize, count - begin));
  });
}

RayRates measure_rays(const Accel& accel, std::span<const Ray> rays, int repeat) {
  if (rays.empty()) return {};
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint8_t> occluded(rays.size());
  const double closest = median_seconds(repeat, [&] {
    for_blocks(rays.size(), [&](std::size_t begin, std::size_t length) {
      accel.intersect(rays.subspan(begin, length), std::span(hits).subspan(begin, length));
    });
  });
  const double any = median_seconds(repeat, [&] {
    for_blocks(rays.size(), [&](std::size_t begin, std::size_t length) {
      accel.occluded(rays.subspan(begin, length), std::span(occluded).subspan(begin, length));
    });
  });
  const auto count = static_cast<double>(rays.size());
  return {rays.size(), count / closest, count / any};
}

Expected<Figures> measure(AccelKind kind, const SceneView& scene, const BenchSettings& settings) {
  Figures figures;
  figures.kind = kind;
  std::unique_ptr<Accel> accel;
  std::vector<double> build_seconds;
  for (int i = 0; i < settings.repeat; ++i) {
    accel.reset();  // not part of building, and two at once may not fit in memory
    const Clock clock;
    accel = make_accel(kind, scene, settings.bvh_quality, settings.leaf_form);
    build_seconds.push_back(clock.seconds());
    if (auto status = check_stop(); !status) return tl::unexpected(status.error());
  }
  figures.build_seconds = median(std::move(build_seconds));
  figures.stats = accel->stats();
  const auto rays = make_camera_rays(scene.camera, settings.camera);
  if (!rays) return tl::unexpected(rays.error());
  figures.coherent = measure_rays(*accel, *rays, settings.repeat);
  const auto bounced = make_bounce_rays(*accel, *rays, settings.camera.seed);
  figures.incoherent = measure_rays(*accel, bounced, settings.repeat);
  return check_stop().map([&] { return figures; });
}

double per_object(std::size_t amount, const AccelStats& stats) {
  return stats.prim_count == 0
             ? 0
             : static_cast<double>(amount) / static_cast<double>(stats.prim_count);
}

std::string as_text(const Figures& f) {
  std::string text = fmt::format("{}\n", accel_name(f.kind));
  const auto add = [&](std::string_view name, const std::string& value) {
    text += fmt::format("    {:<26}{}\n", name, value);
  };
  const auto add_rates = [&](std::string_view name, const RayRates& rates) {
    add(fmt::format("{} rays", name), fmt::format("{}", rates.ray_count));
    add("  closest hit", scaled_text(rates.closest_hit) + " rays/s");
    add("  any hit", scaled_text(rates.any_hit) + " rays/s");
  };
  add("build", fmt::format("{:.6f} s", f.build_seconds));
  add("nodes, leaves, levels",
      fmt::format("{}, {}, {}", f.stats.node_count, f.stats.leaf_count, f.stats.depth));
  add("bytes per object", fmt::format("{:.1f}", per_object(f.stats.bytes, f.stats)));
  add("surface area cost", fmt::format("{:.2f}", f.stats.sah_cost));
  add_rates("coherent", f.coherent);
  add_rates("incoherent", f.incoherent);
  return text;
}

nlohmann::ordered_json as_json(const RayRates& rates) {
  return {{"rays", rates.ray_count},
          {"closest_hit_per_second", rates.closest_hit},
          {"any_hit_per_second", rates.any_hit}};
}

nlohmann::ordered_json as_json(const Figures& f) {
  return {{"accel", accel_name(f.kind)},
          {"build_seconds", f.build_seconds},
          {"nodes", f.stats.node_count},
          {"leaves", f.stats.leaf_count},
          {"depth", f.stats.depth},
          {"bytes", f.stats.bytes},
          {"bytes_per_object", per_object(f.stats.bytes, f.stats)},
          {"sah_cost", f.stats.sah_cost},
          {"coherent", as_json(f.coherent)},
          {"incoherent", as_json(f.incoherent)}};
}

Status print_figures(const std::vector<Figures>& all, const SceneView& scene,
                     const Arguments& arguments) {
  if (!arguments.given("json")) {
    std::string text = fmt::format("{}: {} objects, {} threads, {}\n", arguments.text("SCENE"),
                                   scene.object_count(), thread_count(), kernels().isa);
    for (const Figures& figures : all) text += as_text(figures);
    return print_output(text);
  }
  nlohmann::ordered_json json = {{"scene", arguments.text("SCENE")},
                                 {"objects", scene.object_count()},
                                 {"threads", thread_count()},
                                 {"isa", kernels().isa},
                                 {"repeat", arguments.integer("repeat")}};
  for (const Figures& figures : all) json["accels"].push_back(as_json(figures));
  return print_output(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                      "\n");
}

}  // namespace

Expected<int> run_bench(const Arguments& arguments) {
  catch_stop_signals();
  BenchSettings settings;
  settings.camera.width = arguments.small_integer("width");
  settings.camera.height = arguments.small_integer("height");
  settings.camera.seed = static_cast<std::uint64_t>(arguments.integer("seed"));
  settings.repeat = arguments.small_integer("repeat");
  settings.bvh_quality = parse_bvh_quality(arguments.text("bvh-quality")).value();
  if (arguments.given("bvh-compact")) settings.leaf_form = LeafForm::compact;
  if (auto status = validate(settings.camera).and_then([&] { return set_up_computing(arguments); });
      !status) {
    return tl::unexpected(status.error());
  }
  const auto source = open_scene(arguments);
  if (!source) return tl::unexpected(source.error());
  SceneView scene = source->view();
  scene.bvh = {};  // building is measured too
  std::vector<Figures> all;
  for (const std::string& name : arguments.texts("accel")) {
    const auto figures = measure(parse_accel_kind(name).value(), scene, settings);
    if (!figures) return tl::unexpected(figures.error());
    all.push_back(*figures);
  }
  return print_figures(all, scene, arguments).map([] { return 0; });
}

}  // namespace dapple
