// bench_render: whole pictures, dapple beside the textbook BVH, one core beside all.
#include <fmt/format.h>

#include <cmath>

#include "harness/command_line.h"
#include "harness/interleave.h"
#include "harness/report.h"
#include "image/formats.h"
#include "parallel/parallel.h"
#include "render/counting_accel.h"
#include "render/render_job.h"
#include "scene_file/scene_source.h"
#include "textbook/renderer.h"

namespace dapple::bench {
namespace {

struct Options {
  std::vector<std::string> scenes = {"rgbbox", "irreg"};
  std::string build_scene = "spheres:1000000";
  std::string images;
  std::string json;
  int width = 1000;
  int height = 1000;
  int samples = 1;
  int rounds = 5;
};

std::optional<int> read(int argc, char** argv, Options& o) {
  CommandLine line("Renders scenes with dapple and with the textbook BVH, in turn.");
  line.add_positional("scenes", "scene names or files", o.scenes);
  line.add("--build-scene", "scene for the parallel efficiency of building; - for none",
           o.build_scene);
  line.add("--images", "folder for the pictures of both", o.images);
  line.add("--width", "pixels", o.width);
  line.add("--height", "pixels", o.height);
  line.add("--spp", "samples per pixel", o.samples);
  line.add("--rounds", "repetitions", o.rounds);
  line.add("--json", "file for all figures", o.json);
  return line.parse(argc, argv);
}

struct Efficiency {
  double wall;  // T1 / (n Tn): 1 when n threads are n times as fast as one; other load lowers it
  double cpu;   // processor time of one thread over that of all together: 1 when sharing out costs
                // no work; says nothing of threads that sleep
};

Efficiency efficiency(const Samples& one, const Samples& all) {
  std::vector<double> cpu;
  for (const Seconds& run : all.runs) cpu.push_back(run.cpu);
  return {one.median() / (all.median() * thread_count_of(Cores::all)),
          one.median() / median_of(cpu)};
}

nlohmann::json to_json(const Efficiency& e) { return {{"wall", e.wall}, {"cpu", e.cpu}}; }
std::string to_text(const Efficiency& e) {
  return fmt::format("{:.3f} (by processor time {:.3f})", e.wall, e.cpu);
}

std::uint64_t count_rays(const PreparedScene& scene, const SceneView& view,
                         const RenderSettings& settings, Expected<RenderResult>& picture) {
  auto counting = std::make_unique<CountingAccel>(scene.accel());
  const CountingAccel& counter = *counting;
  const PreparedScene counted(view, std::move(counting));
  picture = render(counted, settings);
  return counter.count();
}

Status write_pictures(const Options& options, const std::string& scene, const Image& ours,
                      const Image& textbook) {
  if (options.images.empty()) return {};
  ImageWriteOptions write;
  write.transfer = Transfer::gamma2;
  const std::string stem = fmt::format("{}/{}", options.images, scene);
  if (auto status = write_image(stem + "-dapple.ppm", ours, write); !status) return status;
  return write_image(stem + "-textbook.ppm", textbook, write);
}

// Both renderings of one scene, and everything they need.
struct Pair {
  const SceneView& scene;
  RenderSettings settings;
  PreparedScene fast;
  textbook::World world;

  Pair(const SceneView& view, const RenderSettings& s)
      : scene(view), settings(s), fast(view, make_accel(AccelKind::fast, view)), world(view) {
    world.build_tree();
  }
  void render_fast() const { static_cast<void>(render(fast, settings)); }
  void render_textbook() const {
    static_cast<void>(textbook::render(world, scene.camera, settings));
  }
};

struct Rate {
  Samples samples;
  std::uint64_t ray_count;
  double million_per_second() const {
    return 1e-6 * static_cast<double>(ray_count) / samples.median();
  }
};

// Rays per second of `a` over those of `b`; the rounds' extremes around it.
Ratio rate_ratio(const Rate& a, const Rate& b) {
  Ratio ratio = time_ratio(b.samples, a.samples);
  const double rays = static_cast<double>(a.ray_count) / static_cast<double>(b.ray_count);
  for (double* value : {&ratio.median, &ratio.low, &ratio.high}) *value *= rays;
  return ratio;
}

void report_scene(const std::string& name, std::span<const Rate> rates, Report& report) {
  Table table({"renderer", "cores", "million rays/s", "seconds", "spread"});
  for (const Rate& rate : rates) {
    const Samples& s = rate.samples;
    table.add_row({s.name, std::string(cores_name(s.cores)),
                   fmt::format("{:.3f}", rate.million_per_second()),
                   fmt::format("{:.3f}", s.median()), fmt::format("{:.0f} %", 100 * s.spread())});
    nlohmann::json row = to_json(s);
    row["scene"] = name;
    row["cores"] = cores_name(s.cores);
    row["ray_count"] = rate.ray_count;
    row["million_per_second"] = rate.million_per_second();
    report.add("render", std::move(row));
    report.check_noise(fmt::format("{}, {}, {}", name, s.name, cores_name(s.cores)), s);
  }
  const Ratio one = rate_ratio(rates[0], rates[1]), all = rate_ratio(rates[2], rates[3]);
  const Efficiency own = efficiency(rates[0].samples, rates[2].samples);
  report.add("render_ratios", {{"scene", name},
                               {"one_core", to_json(one)},
                               {"all_cores", to_json(all)},
                               {"efficiency", to_json(own)}});
  report.print(fmt::format("{}: dapple / textbook {} on one core, {} on all; "
                           "parallel efficiency of dapple {}",
                           name, to_text(one), to_text(all), to_text(own)),
               table);
}

Status measure_scene(const std::string& name, const Options& options, Report& report) {
  const auto source = SceneSource::open(name);
  if (!source) return tl::unexpected(source.error());
  RenderSettings settings;
  settings.width = options.width;
  settings.height = options.height;
  settings.samples_per_pixel = options.samples;
  const Pair pair(source->view(), settings);

  Expected<RenderResult> ours;
  const std::uint64_t own_rays = count_rays(pair.fast, pair.scene, settings, ours);
  if (!ours) return tl::unexpected(ours.error());
  const auto textbook = textbook::render(pair.world, pair.scene.camera, settings);
  if (auto s = write_pictures(options, name, ours->image, textbook.image); !s) return s;

  std::vector<Task> tasks;
  for (const Cores cores : {Cores::one, Cores::all}) {
    tasks.push_back({"dapple", {}, [&] { pair.render_fast(); }, cores});
    tasks.push_back({"textbook", {}, [&] { pair.render_textbook(); }, cores});
  }
  auto samples = run_interleaved(tasks, options.rounds, WarmUp::one_round);
  std::vector<Rate> rates;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    rates.push_back({std::move(samples[i]), i % 2 == 0 ? own_rays : textbook.ray_count});
  }
  report_scene(name, rates, report);
  return {};
}

// Building alone: how well it uses all cores, and how the textbook builds the same scene.
Status measure_build(const std::string& name, const Options& options, Report& report) {
  const auto source = SceneSource::open(name);
  if (!source) return tl::unexpected(source.error());
  const SceneView& scene = source->view();
  textbook::World world(scene);
  std::unique_ptr<Accel> accel;
  std::vector<Task> tasks;
  for (const Cores cores : {Cores::one, Cores::all}) {
    tasks.push_back({"dapple", [&] { accel.reset(); },
                     [&] { accel = make_accel(AccelKind::fast, scene); }, cores});
  }
  tasks.push_back({"textbook", {}, [&] { world.build_tree(); }, Cores::one});
  const auto samples = run_interleaved(tasks, options.rounds, WarmUp::one_round);
  Table table({"build", "cores", "seconds", "spread"});
  for (const Samples& s : samples) {
    table.add_row({s.name, std::string(cores_name(s.cores)), fmt::format("{:.3f}", s.median()),
                   fmt::format("{:.0f} %", 100 * s.spread())});
    nlohmann::json row = to_json(s);
    row["scene"] = name;
    row["cores"] = cores_name(s.cores);
    report.add("build", std::move(row));
    report.check_noise(fmt::format("{}, build, {}, {}", name, s.name, cores_name(s.cores)), s);
  }
  const Efficiency value = efficiency(samples[0], samples[1]);
  report.add("build_ratios", {{"scene", name},
                              {"efficiency", to_json(value)},
                              {"textbook", to_json(time_ratio(samples[2], samples[0]))}});
  report.print(fmt::format("{}: parallel efficiency of building {}", name, to_text(value)), table);
  return {};
}

Status run(const Options& options) {
  Report report("render");
  for (const std::string& scene : options.scenes) {
    if (auto status = measure_scene(scene, options, report); !status) return status;
  }
  if (options.build_scene != "-") {
    if (auto status = measure_build(options.build_scene, options, report); !status) return status;
  }
  return report.write(options.json);
}

}  // namespace
}  // namespace dapple::bench

int main(int argc, char** argv) {
  dapple::bench::Options options;
  if (const auto code = dapple::bench::read(argc, argv, options)) return *code;
  const dapple::Status status = dapple::bench::run(options);
  if (status) return 0;
  fmt::print(stderr, "bench_render: {}\n", to_string(status.error()));
  return static_cast<int>(status.error().code);
}
