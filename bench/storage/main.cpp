// bench_scene_file: storing and loading large scenes, beside what memory and the file system do
// with as many bytes.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "accel/accel.h"
#include "accel/wide_builder.h"
#include "harness/command_line.h"
#include "harness/interleave.h"
#include "harness/report.h"
#include "scene_file/mapped_scene.h"
#include "scene_file/scene_source.h"
#include "scene_file/writer.h"
#include "storage/plain_file.h"

namespace dapple::bench {
namespace {

struct Options {
  std::vector<std::string> scenes = {"spheres:10000000"};
  std::string folder = ".";
  std::string json;
  int rounds = 5;
};

std::optional<int> read(int argc, char** argv, Options& o) {
  CommandLine line("Stores and loads scenes with and without their BVH.");
  line.add_positional("scenes", "scene names or files", o.scenes);
  line.add("--folder", "where the files are written; they are removed again", o.folder);
  line.add("--rounds", "repetitions", o.rounds);
  line.add("--json", "file for all figures", o.json);
  return line.parse(argc, argv);
}

// Bytes of the arrays that a renderer has in memory.
std::size_t raw_bytes(const SceneView& scene) {
  std::size_t bytes = scene.spheres.size_bytes() + scene.sphere_materials.size_bytes();
  for (std::size_t k = 0; k < kRectangleKindCount; ++k) {
    bytes += scene.rectangles[k].size_bytes() + scene.rectangle_materials[k].size_bytes();
  }
  return bytes + scene.bvh.nodes.size_bytes() + scene.bvh.rows.size_bytes();
}

// A scene stored in a file, removed at the end.
struct Stored {
  std::string name;
  std::string path;
  SceneView scene;

  ~Stored() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
  std::size_t file_bytes() const { return std::filesystem::file_size(path); }
};

// Everything until the first ray has found its hit.
Status load_and_trace(const std::string& path, const VerifyOptions& options) {
  const auto scene = MappedScene::open(path, options);
  if (!scene) return tl::unexpected(scene.error());
  const auto accel = make_accel(AccelKind::fast, scene->view());
  Ray ray;
  ray.origin = Vec3f(scene->view().camera.look_from);
  ray.direction = Vec3f(scene->view().camera.look_at - scene->view().camera.look_from);
  accel->intersect(ray);
  return {};
}

// One thing to measure and how many bytes it moves.
struct Step {
  Task task;
  std::size_t bytes;
};

// A status that the first failure of any step sets.
struct Outcome {
  Status status;
  void keep(Status other) {
    if (status && !other) status = std::move(other);
  }
};

std::vector<Step> steps_of(const Stored& file, Outcome& outcome) {
  const std::size_t bytes = file.file_bytes();
  const std::string plain = file.path + ".plain";
  const auto load = [&file, &outcome](const VerifyOptions& options) {
    return [&file, &outcome, options] {
      const auto scene = MappedScene::open(file.path, options);
      outcome.keep(scene ? Status{} : Status(tl::unexpected(scene.error())));
    };
  };
  const auto first_ray = [&file, &outcome](const VerifyOptions& options) {
    return [&file, &outcome, options] { outcome.keep(load_and_trace(file.path, options)); };
  };
  VerifyOptions trusting, for_bvh;
  trusting.hashes = false;
  for_bvh.scope = VerifyScope::bvh_only;
  VerifyOptions for_bvh_trusting = for_bvh;
  for_bvh_trusting.hashes = false;

  std::vector<Step> steps = {
      {{"memcpy", {}, [bytes] { copy_in_memory(bytes); }}, bytes},
      {{"read, page cache", {}, [&] { outcome.keep(read_plain(file.path)); }}, bytes},
      {{"write, page cache",
        {},
        [=, &outcome] { outcome.keep(write_plain(plain, bytes, Flush::no)); }},
       bytes},
      {{"write and fsync",
        {},
        [=, &outcome] { outcome.keep(write_plain(plain, bytes, Flush::yes)); }},
       bytes},
      {{"store", {}, [&] { outcome.keep(store_scene_file(file.path, file.scene)); }}, bytes},
      {{"load", {}, load({})}, bytes},
      {{"load, trusted", {}, load(trusting)}, bytes}};
  if (!file.scene.bvh.empty()) {
    steps.push_back({{"first ray", {}, first_ray({})}, bytes});
    steps.push_back({{"first ray, BVH only", {}, first_ray(for_bvh)}, bytes});
    steps.push_back({{"first ray, BVH only, trusted", {}, first_ray(for_bvh_trusting)}, bytes});
  }
  return steps;
}

Status measure_file(const std::string& scene_name, const Stored& file, int rounds, Report& report) {
  if (auto status = store_scene_file(file.path, file.scene); !status) return status;
  Outcome outcome;
  const std::vector<Step> steps = steps_of(file, outcome);
  std::vector<Task> tasks;
  for (const Step& step : steps) tasks.push_back(step.task);
  const auto samples = run_interleaved(tasks, rounds, WarmUp::one_round);
  if (!outcome.status) return outcome.status;

  const double ratio =
      static_cast<double>(file.file_bytes()) / static_cast<double>(raw_bytes(file.scene));
  Table table({"step", "seconds", "GB/s", "of page cache read", "spread"});
  const double cache = samples[1].median();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Samples& s = samples[i];
    const double rate = 1e-9 * static_cast<double>(steps[i].bytes) / s.median();
    table.add_row({s.name, fmt::format("{:.4f}", s.median()), fmt::format("{:.2f}", rate),
                   fmt::format("{:.2f}", cache / s.median()),
                   fmt::format("{:.0f} %", 100 * s.spread())});
    nlohmann::json row = to_json(s);
    row["scene"] = scene_name;
    row["file"] = file.name;
    row["bytes"] = steps[i].bytes;
    row["gb_per_second"] = rate;
    row["of_page_cache_read"] = cache / s.median();
    report.add("steps", std::move(row));
    report.check_noise(fmt::format("{}, {}, {}", scene_name, file.name, s.name), s);
  }
  report.add("files", {{"scene", scene_name},
                       {"file", file.name},
                       {"bytes", file.file_bytes()},
                       {"of_raw_arrays", ratio}});
  report.print(fmt::format("{}, {}: {} bytes, {:.3f} times the raw arrays", scene_name, file.name,
                           file.file_bytes(), ratio),
               table);
  return {};
}

Status measure(const std::string& name, const Options& options, Report& report) {
  const auto source = SceneSource::open(name);
  if (!source) return tl::unexpected(source.error());
  SceneView scene = source->view();
  const std::string stem = fmt::format("{}/bench-scene-file", options.folder);
  scene.bvh = {};
  {
    const Stored without{"without BVH", stem + "-plain.scene", scene};
    if (auto s = measure_file(name, without, options.rounds, report); !s) return s;
  }
  const WideBvh bvh = build_wide_bvh(scene);
  scene.bvh = bvh.view();
  const Stored with{"with BVH", stem + "-bvh.scene", scene};
  return measure_file(name, with, options.rounds, report);
}

Status run(const Options& options) {
  Report report("scene_file");
  for (const std::string& scene : options.scenes) {
    if (auto status = measure(scene, options, report); !status) return status;
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
  fmt::print(stderr, "bench_scene_file: {}\n", to_string(status.error()));
  return static_cast<int>(status.error().code);
}
