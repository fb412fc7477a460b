// bench_kernels: builds and traverses, dapple beside its peers, the same rays for all.
#include <fmt/format.h>

#include "harness/command_line.h"
#include "kernels/mesh_scenes.h"
#include "kernels/peers.h"
#include "scene_file/scene_source.h"

namespace dapple::bench {
namespace {

struct Options {
  std::vector<std::string> scenes = {"irreg:50",    "irreg:1000",     "spheres:1000000",
                                     "bumps:70000", "bumps:1000000",  "city:700000",
                                     "soup:500000", "interior:300000"};
  std::string cores = "both";
  ContenderChoice choice;
  std::string json;
  int side = 1000;
  int rounds = 5;
  int build_rounds = 3;
};

std::optional<int> read(int argc, char** argv, Options& o) {
  CommandLine line("Builds and traverses scenes with dapple and its peers, in turn.");
  line.add_positional(
      "scenes",
      "scene names or files, or bumps:N, city:N, girders:N, soup:N, interior:N for meshes",
      o.scenes);
  line.add("--cores", "one, all or both", o.cores);
  line.add("--accel", "dapple's structure: fast, median or linear", o.choice.accel);
  line.add("--only", "one contender: dapple or embree", o.choice.only);
  line.add("--bvh-quality", "dapple's build quality: low, medium or high", o.choice.quality);
  line.add("--embree-quality", "Embree's build quality: low, medium or high",
           o.choice.embree_quality);
  line.add("--compact", "both ask for trees that take less memory", o.choice.compact);
  line.add("--side", "width and height of the picture; a set has its square of rays", o.side);
  line.add("--rounds", "repetitions of each way of tracing", o.rounds);
  line.add("--build-rounds", "repetitions of each build", o.build_rounds);
  line.add("--json", "file for all figures", o.json);
  return line.parse(argc, argv);
}

// All cores first: thread pools must be made before the calling thread is pinned.
Expected<std::vector<Cores>> parse_cores(const std::string& name) {
  if (name == "one") return std::vector{Cores::one};
  if (name == "all") return std::vector{Cores::all};
  if (name == "both") return std::vector{Cores::all, Cores::one};
  return fail(Errc::usage, "--cores", "one, all or both");
}

Status measure(const std::string& name, const SceneView& scene, const Options& options,
               std::span<const Cores> all_cores, Report& report) {
  const auto contenders = make_contenders(options.choice);
  if (!contenders) return tl::unexpected(contenders.error());

  std::vector<RaySet> sets;
  for (const Cores cores : all_cores) {
    compare_builds(name, scene, *contenders, cores, options.build_rounds, report);
    if (sets.empty()) {
      auto made = make_ray_sets(scene, options.side, [&](std::span<const Ray> rays) {
        return trace_once(*contenders->front(), rays, Query::closest);
      });
      if (!made) return tl::unexpected(made.error());
      sets = std::move(*made);
    }
    compare_tracing(name, sets, *contenders, cores, options.rounds, report);
  }
  compare_hits(name, scene, sets, *contenders, report);
  return {};
}

Status measure(const std::string& name, const Options& options, std::span<const Cores> all_cores,
               Report& report) {
  const auto mesh = make_mesh_scene(name);
  if (!mesh) return tl::unexpected(mesh.error());
  if (*mesh) return measure(name, SceneView(**mesh), options, all_cores, report);
  const auto source = SceneSource::open(name);
  if (!source) return tl::unexpected(source.error());
  return measure(name, source->view(), options, all_cores, report);
}

Status run(const Options& options) {
  const auto all_cores = parse_cores(options.cores);
  if (!all_cores) return tl::unexpected(all_cores.error());
  Report report("kernels");
  for (const std::string& scene : options.scenes) {
    if (auto status = measure(scene, options, *all_cores, report); !status) return status;
    // What is finished is kept if a later scene is interrupted.
    if (auto status = report.write(options.json); !status) return status;
  }
  return {};
}

}  // namespace
}  // namespace dapple::bench

int main(int argc, char** argv) {
  dapple::bench::Options options;
  if (const auto code = dapple::bench::read(argc, argv, options)) return *code;
  const dapple::Status status = dapple::bench::run(options);
  if (status) return 0;
  fmt::print(stderr, "bench_kernels: {}\n", to_string(status.error()));
  return static_cast<int>(status.error().code);
}
