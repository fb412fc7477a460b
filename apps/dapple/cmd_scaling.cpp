#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "accel/kernels/dispatch.h"
#include "common/program.h"
#include "common/standard_output.h"
#include "common/stop_signal.h"
#include "dapple/commands.h"
#include "dapple/common_options.h"
#include "dapple/scaling/json.h"
#include "dapple/scaling/output.h"
#include "dapple/scaling/report_text.h"
#include "parallel/parallel.h"
#include "parallel/pinning.h"

namespace dapple {
namespace {

using namespace scaling;

StudySettings study_settings(const Arguments& arguments) {
  StudySettings settings;
  settings.threads = arguments.given("threads") ? tidy_thread_counts(arguments.integers("threads"))
                                                : default_thread_counts(thread_count());
  settings.rounds = arguments.small_integer("repeat");
  settings.patience = static_cast<double>(arguments.integer("patience"));
  settings.pin = !arguments.given("no-pin");
  return settings;
}

BaseWork base_work(const Arguments& arguments) {
  BaseWork base;
  base.scene = arguments.text("SCENE");
  base.width = arguments.small_integer("width");
  base.height = arguments.small_integer("height");
  base.ray_samples = arguments.small_integer("spp");
  base.ray_bvh_samples = arguments.small_integer("bvh-spp");
  base.build_objects = arguments.small_integer("objects");
  return base;
}

RenderSettings render_settings(const BaseWork& base, WorkKind kind) {
  RenderSettings settings;
  settings.width = base.width;
  settings.height = base.height;
  settings.samples_per_pixel = kind == WorkKind::ray ? base.ray_samples : base.ray_bvh_samples;
  return settings;
}

using Workloads = std::vector<std::unique_ptr<Workload>>;

Workloads make_workloads(const Arguments& arguments, const SceneView& scene, const BaseWork& base) {
  Workloads workloads;
  for (const std::string& name : arguments.given("work")
                                     ? arguments.texts("work")
                                     : std::vector<std::string>{"ray", "ray_bvh", "build"}) {
    const WorkKind kind = parse_work(name).value();
    const auto same = [&](const auto& workload) { return workload->kind() == kind; };
    if (std::any_of(workloads.begin(), workloads.end(), same)) continue;
    workloads.push_back(kind == WorkKind::build
                            ? make_building(base.build_objects)
                            : make_rendering(kind, scene, render_settings(base, kind)));
  }
  return workloads;
}

// The largest run must be one that rendering accepts.
Status check_sizes(const BaseWork& base, const StudySettings& study) {
  for (const WorkKind kind : {WorkKind::ray, WorkKind::ray_bvh}) {
    RenderSettings settings = render_settings(base, kind);
    settings.samples_per_pixel *= study.threads.back();
    if (auto status = validate(settings); !status) return status;
  }
  return {};
}

// How many runs are done, on standard error when that is a terminal; gone when it is.
class RunCounter {
 public:
  explicit RunCounter(bool wanted) : enabled_(wanted && ::isatty(STDERR_FILENO) == 1) {}
  ~RunCounter() {
    if (enabled_) print_message("\r\033[K");
  }
  RunCounter(const RunCounter&) = delete;
  RunCounter& operator=(const RunCounter&) = delete;

  void update(std::size_t done, std::size_t total) const {
    if (enabled_) print_message(fmt::format("\r{} of {} runs\033[K", done, total));
  }

 private:
  bool enabled_;
};

Expected<Result> measure(const Workloads& workloads, const BaseWork& base,
                         const StudySettings& settings, bool show_progress) {
  Result result;
  result.base = base;
  result.machine = describe_machine();
  const auto run = [&] {
    const RunCounter counter(show_progress);
    return run_study(workloads, settings, [&](std::size_t done, std::size_t total) {
      counter.update(done, total);
      return check_stop();
    });
  };
  auto measurements = run();
  if (!measurements) return tl::unexpected(measurements.error());
  result.machine.load_after = load_average();
  result.machine.activity = mean_activity(*measurements);
  result.measurements = std::move(*measurements);
  result.curves = make_curves(result.measurements, result.machine.cores);
  result.warnings = find_warnings(result.curves, result.measurements, result.machine, settings.pin);
  return result;
}

Status report_result(const Result& result, const Arguments& arguments) {
  for (const std::string& warning : result.warnings) {
    print_message(fmt::format("dapple: warning: {}\n", warning));
  }
  if (arguments.given("json")) return print_output(to_json_text(result));
  if (arguments.given("quiet")) return {};
  return print_output(to_text(result));
}

}  // namespace

Expected<int> run_scaling(const Arguments& arguments) {
  survive_closed_pipes();
  catch_stop_signals();
  const StudySettings settings = study_settings(arguments);
  const BaseWork base = base_work(arguments);
  const std::string folder = arguments.text("output");
  if (auto status =
          check_sizes(base, settings).and_then([] { return check_isa_override(); }).and_then([&] {
            return prepare_folder(folder);
          });
      !status) {
    return tl::unexpected(status.error());
  }
  const auto source = open_scene(arguments);
  if (!source) return tl::unexpected(source.error());
  SceneView scene = source->view();
  scene.bvh = {};  // the tree of every machine is the one built here
  const Workloads workloads = make_workloads(arguments, scene, base);
  const auto result = measure(workloads, base, settings, !arguments.given("quiet"));
  if (!result) return tl::unexpected(result.error());
  if (auto status = write_files(*result, folder); !status) return tl::unexpected(status.error());
  return report_result(*result, arguments).map([] { return 0; });
}

}  // namespace dapple
