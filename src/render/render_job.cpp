#include "render/render_job.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "parallel/parallel.h"
#include "render/camera_rays.h"
#include "render/classic_paths.h"
#include "render/film.h"

namespace dapple {
namespace {

constexpr int kTileSide = 32;
constexpr int kSamplesPerUnit =
    4;  // with the tile: 4096 paths in flight, in the second-level cache

// A pure function of the job: which pixels and which samples.
struct Unit {
  Tile tile;
  SampleRange samples;
};

std::vector<Unit> units_of(const RenderSettings& s) {
  std::vector<Unit> units;
  for (int first = 0; first < s.samples_per_pixel; first += kSamplesPerUnit) {
    const SampleRange samples{first, std::min(first + kSamplesPerUnit, s.samples_per_pixel)};
    for (int y = 0; y < s.height; y += kTileSide) {
      for (int x = 0; x < s.width; x += kTileSide) {
        const Tile tile{x, y, std::min(x + kTileSide, s.width), std::min(y + kTileSide, s.height)};
        units.push_back({tile, samples});
      }
    }
  }
  return units;
}

// Counts finished units and tells the caller.
class Progress {
 public:
  Progress(const RenderControl& control, std::size_t total) : control_(control), total_(total) {}

  void count_one() {
    if (!control_.progress) return;
    const std::lock_guard lock(mutex_);
    control_.progress(++done_, total_);
  }

 private:
  const RenderControl& control_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

}  // namespace

Expected<RenderResult> render(const PreparedScene& scene, const RenderSettings& settings,
                              const RenderControl& control) {
  if (auto status = validate(settings); !status) return tl::unexpected(status.error());
  const auto camera = CameraRays::create(scene.camera(), settings);
  if (!camera) return tl::unexpected(camera.error());
  const ClassicPaths paths(scene, *camera, settings);
  const std::vector<Unit> units = units_of(settings);
  Film film(settings.width, settings.height);
  Progress progress(control, units.size());
  const auto cancelled = [&] { return control.cancel != nullptr && control.cancel->load(); };

  parallel_for_dynamic(units.size(), [&](std::size_t i) {
    if (cancelled()) return;
    TileSums sums(units[i].tile);
    paths.render(units[i].samples, sums);
    film.merge(sums);
    progress.count_one();
  });
  if (cancelled()) return fail(Errc::interrupted, "", "rendering was interrupted");
  return RenderResult{film.to_image(settings.samples_per_pixel), film.dropped()};
}

}  // namespace dapple
