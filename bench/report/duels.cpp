#include "report/duels.h"

#include "harness/cores.h"
#include "harness/samples.h"
#include "harness/stopwatch.h"
#include "render/counting_accel.h"
#include "report/csv_file.h"
#include "report/opened_scene.h"

namespace dapple::bench {
namespace {

struct Workload {
  const char* name;
  const char* scene;
  int width, height, samples;
};

constexpr Workload kWorkloads[] = {
    {"irreg", "irreg", 320, 320, 1},
    {"rgbbox", "rgbbox", 320, 320, 4},
    {"nice", "nice", 320, 320, 16},
    {"empty", "empty", 320, 320, 16},
    {"large", "spheres:1000000", 320, 320, 1},
    {"glimpse", "spheres:1000000", 8, 8, 1},
};
constexpr int kRounds = 5;
// Brute force over a million spheres takes minutes for a whole picture: it is rendered at this
// size, and what its rays cost is what a ray of the larger picture costs.
constexpr int kSmallSide = 12;
constexpr double kLeastSeconds = 0.05;  // shorter renderings are repeated within a measurement

double render_seconds(const PreparedScene& scene, const RenderSettings& settings) {
  int times = 0;
  const Stopwatch stopwatch;
  do {
    static_cast<void>(render(scene, settings));
    ++times;
  } while (stopwatch.elapsed().cpu < kLeastSeconds);
  return stopwatch.elapsed().cpu / times;
}

double count_rays(const OpenedScene& scene, const PreparedScene& prepared,
                  const RenderSettings& settings) {
  auto counting = std::make_unique<CountingAccel>(prepared.accel());
  const CountingAccel& counter = *counting;
  const PreparedScene counted(scene.view(), std::move(counting));
  static_cast<void>(render(counted, settings));
  return static_cast<double>(counter.count());
}

struct Contender {
  AccelKind kind;
  RenderSettings settings;  // of what is rendered
  std::vector<double> prepare_seconds = {}, seconds_per_ray = {};

  void measure(const OpenedScene& scene) {
    const Stopwatch stopwatch;
    const auto prepared = scene.prepare(kind);
    prepare_seconds.push_back(stopwatch.elapsed().cpu);
    const double seconds = render_seconds(*prepared, settings);
    seconds_per_ray.push_back(seconds / rays);
  }

  double rays = 1;
};

Status measure(const Workload& work, CsvFile& csv) {
  const auto scene = OpenedScene::open(work.scene);
  if (!scene) return tl::unexpected(scene.error());
  const RenderSettings whole = picture(work.width, work.height, work.samples);
  const std::size_t objects = scene->view().object_count();
  const bool too_long = objects > 100'000 && work.width > kSmallSide;
  const RenderSettings small = picture(kSmallSide, kSmallSide, 1);
  const auto tree = scene->prepare(AccelKind::fast);
  const double rays = count_rays(*scene, *tree, whole);
  Contender ray{AccelKind::linear, too_long ? small : whole};
  Contender bvh{AccelKind::fast, whole};
  ray.rays = too_long ? count_rays(*scene, *tree, small) : rays;
  bvh.rays = rays;
  const CoreScope one(Cores::one);
  for (int round = 0; round < (objects > 100'000 ? 3 : kRounds); ++round) {
    ray.measure(*scene);
    bvh.measure(*scene);
  }
  const double ray_prepare = median_of(ray.prepare_seconds);
  const double bvh_prepare = median_of(bvh.prepare_seconds);
  const double ray_each = median_of(ray.seconds_per_ray), bvh_each = median_of(bvh.seconds_per_ray);
  const double ray_total = ray_prepare + rays * ray_each;
  const double bvh_total = bvh_prepare + rays * bvh_each;
  // Rays from which on the tree pays; 0 when it never does.
  const double break_even =
      ray_each > bvh_each ? std::max(0.0, bvh_prepare - ray_prepare) / (ray_each - bvh_each) : 0;
  csv.add(work.name, work.scene, objects, work.width, work.samples, rays, digits(1e3 * ray_prepare),
          digits(1e9 * ray_each), digits(1e3 * ray_total), digits(1e3 * bvh_prepare),
          digits(1e9 * bvh_each), digits(1e3 * bvh_total), digits(ray_total / bvh_total),
          digits(bvh_total / ray_total), digits(break_even), too_long ? 1 : 0);
  return {};
}

}  // namespace

Status study_duels(const std::string& folder) {
  CsvFile csv({"workload", "scene", "objects", "side", "samples", "rays", "ray_prepare_ms",
               "ray_ns_per_ray", "ray_total_ms", "bvh_prepare_ms", "bvh_ns_per_ray", "bvh_total_ms",
               "gain", "loss", "break_even_rays", "ray_from_small_picture"});
  for (const Workload& work : kWorkloads) {
    if (auto status = measure(work, csv); !status) return status;
  }
  return csv.write(folder + "/duels.csv");
}

}  // namespace dapple::bench
