#include "report/schedules.h"

#include <omp.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "harness/samples.h"
#include "harness/stopwatch.h"
#include "parallel/pinning.h"
#include "render/camera_rays.h"
#include "render/classic_paths.h"
#include "report/csv_file.h"
#include "report/opened_scene.h"

namespace dapple::bench {
namespace {

constexpr const char* kScene = "irreg";
constexpr int kSide = 480;
constexpr int kThreads = 2;
constexpr int kRounds = 5;
constexpr int kSamples = 1;

double thread_cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Run {
  double wall = 0;
  std::vector<double> busy = std::vector<double>(kThreads);      // on the wall, in the loop's body
  std::vector<double> busy_cpu = std::vector<double>(kThreads);  // of that, on a processor
};

// One row of the picture is one iteration.
class RowRenderer {
 public:
  RowRenderer(const PreparedScene& scene, const CameraRays& camera, const RenderSettings& settings)
      : paths_(scene, camera, settings), settings_(settings) {}

  void render(int row) const {
    TileOutput output{TileSums({0, row, settings_.width, row + 1}), std::nullopt};
    paths_.render({0, settings_.samples_per_pixel}, output);
  }

  void render_timed(int row, Run& run) const {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const double cpu = thread_cpu_seconds(), wall = now().wall;
    render(row);
    run.busy_cpu[thread] += thread_cpu_seconds() - cpu;
    run.busy[thread] += now().wall - wall;
  }

  int rows() const { return settings_.height; }

 private:
  ClassicPaths paths_;
  const RenderSettings& settings_;
};

// What one would write first: rows are alike, so each thread gets as many.
Run run_static(const RowRenderer& renderer) {
  Run run;
  const Stopwatch stopwatch;
#pragma omp parallel for schedule(static)
  for (int row = 0; row < renderer.rows(); ++row) renderer.render_timed(row, run);
  run.wall = stopwatch.elapsed().wall;
  return run;
}

Run run_dynamic(const RowRenderer& renderer) {
  Run run;
  const Stopwatch stopwatch;
#pragma omp parallel for schedule(dynamic, 1)
  for (int row = 0; row < renderer.rows(); ++row) renderer.render_timed(row, run);
  run.wall = stopwatch.elapsed().wall;
  return run;
}

// The product's own loop over tiles.
Run run_tiles(const PreparedScene& scene, const RenderSettings& settings) {
  ThreadTimes times;
  RenderControl control;
  control.thread_times = &times;
  const Stopwatch stopwatch;
  static_cast<void>(render(scene, settings, control));
  Run run;
  run.wall = stopwatch.elapsed().wall;
  const auto busy = times.busy();
  for (std::size_t i = 0; i < busy.size(); ++i) {
    run.busy[i] = busy[i].wall;
    run.busy_cpu[i] = busy[i].cpu;
  }
  return run;
}

const Run& median_run(std::vector<Run>& runs) {
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.wall < b.wall; });
  return runs[runs.size() / 2];
}

void add_run(const char* name, const Run& run, CsvFile& csv) {
  for (std::size_t i = 0; i < run.busy.size(); ++i) {
    csv.add(name, i, digits(run.wall), digits(run.busy[i]), digits(run.busy_cpu[i]),
            digits(run.wall - run.busy[i]), digits(1 - run.busy[i] / run.wall));
  }
}

// Processor seconds of each row on one thread, the least of the rounds.
std::vector<double> row_costs(const RowRenderer& renderer) {
  std::vector<double> costs(static_cast<std::size_t>(renderer.rows()), 1e9);
  for (int round = 0; round < kRounds; ++round) {
    for (int row = 0; row < renderer.rows(); ++row) {
      const double start = thread_cpu_seconds();
      renderer.render(row);
      double& cost = costs[static_cast<std::size_t>(row)];
      cost = std::min(cost, thread_cpu_seconds() - start);
    }
  }
  return costs;
}

double utilisation(const std::vector<double>& loads) {
  const double sum = std::accumulate(loads.begin(), loads.end(), 0.0);
  return sum / (static_cast<double>(loads.size()) * *std::max_element(loads.begin(), loads.end()));
}

// Each thread gets as many rows, one after the other.
double static_utilisation(const std::vector<double>& costs, std::size_t threads) {
  std::vector<double> loads(threads);
  for (std::size_t row = 0; row < costs.size(); ++row) {
    loads[row * threads / costs.size()] += costs[row];
  }
  return utilisation(loads);
}

// The next row goes to whoever is free first.
double dynamic_utilisation(const std::vector<double>& costs, std::size_t threads) {
  std::vector<double> loads(threads);
  for (const double cost : costs) *std::min_element(loads.begin(), loads.end()) += cost;
  return utilisation(loads);
}

Status write_costs(const std::vector<double>& costs, const std::string& folder) {
  constexpr std::size_t kGroup = 8;  // rows a point of the plot
  CsvFile rows({"row", "microseconds"});
  for (std::size_t row = 0; row + kGroup <= costs.size(); row += kGroup) {
    const double sum =
        std::accumulate(costs.begin() + static_cast<std::ptrdiff_t>(row),
                        costs.begin() + static_cast<std::ptrdiff_t>(row + kGroup), 0.0);
    rows.add(row + kGroup / 2, digits(1e6 * sum / kGroup));
  }
  CsvFile predicted({"threads", "static", "dynamic"});
  for (const std::size_t threads : {1, 2, 4, 8, 16, 32, 64}) {
    predicted.add(threads, digits(static_utilisation(costs, threads)),
                  digits(dynamic_utilisation(costs, threads)));
  }
  return rows.write(folder + "/rows.csv").and_then([&] {
    return predicted.write(folder + "/predicted.csv");
  });
}

}  // namespace

Status study_schedules(const std::string& folder) {
  const auto scene = OpenedScene::open(kScene);
  if (!scene) return tl::unexpected(scene.error());
  const auto prepared = scene->prepare(AccelKind::linear);
  const RenderSettings settings = picture(kSide, kSide, kSamples);
  const auto camera = CameraRays::create(prepared->camera(), settings);
  if (!camera) return tl::unexpected(camera.error());
  const RowRenderer renderer(*prepared, *camera, settings);
  std::array<std::vector<Run>, 3> runs;
  for (int round = -1; round < kRounds; ++round) {  // the first warms up
    const PinnedTeam team(kThreads);
    const std::array<Run, 3> next = {run_static(renderer), run_dynamic(renderer),
                                     run_tiles(*prepared, settings)};
    for (std::size_t i = 0; i < 3 && round >= 0; ++i) runs[i].push_back(next[i]);
  }
  CsvFile csv({"schedule", "thread", "wall", "busy", "busy_cpu", "idle", "idle_share"});
  add_run("static", median_run(runs[0]), csv);
  add_run("dynamic", median_run(runs[1]), csv);
  add_run("tiles", median_run(runs[2]), csv);
  if (auto status = csv.write(folder + "/schedules.csv"); !status) return status;
  return write_costs(row_costs(renderer), folder);
}

}  // namespace dapple::bench
