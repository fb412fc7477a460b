#include "render/render_job.h"

#include <algorithm>
#include <mutex>

#include "parallel/parallel.h"
#include "render/camera_rays.h"
#include "render/classic_paths.h"
#include "render/film.h"

namespace dapple {
namespace {

constexpr int kTileSide = 32;
// With the tile: 4096 paths in flight, which the second-level cache holds.
constexpr int kSamplesPerUnit = 4;

// A pure function of the job: which pixels and which samples.
struct Unit {
  Tile tile;
  SampleRange samples;
};

// The units of a job by number: all tiles of the first samples, then of the next.
class Units {
 public:
  explicit Units(const RenderSettings& s)
      : settings_(s),
        columns_(count_of(s.width, kTileSide)),
        rows_(count_of(s.height, kTileSide)),
        blocks_(count_of(s.samples_per_pixel, kSamplesPerUnit)) {}

  std::size_t size() const { return columns_ * rows_ * blocks_; }

  Unit operator[](std::size_t i) const {
    const auto column = static_cast<int>(i % columns_);
    const auto row = static_cast<int>(i / columns_ % rows_);
    const auto block = static_cast<int>(i / columns_ / rows_);
    const RenderSettings& s = settings_;
    const int x = column * kTileSide, y = row * kTileSide, first = block * kSamplesPerUnit;
    return {{x, y, std::min(x + kTileSide, s.width), std::min(y + kTileSide, s.height)},
            {first, std::min(first + kSamplesPerUnit, s.samples_per_pixel)}};
  }

 private:
  static std::size_t count_of(int whole, int part) {
    return (static_cast<std::size_t>(whole) + static_cast<std::size_t>(part) - 1) /
           static_cast<std::size_t>(part);
  }

  const RenderSettings& settings_;
  std::size_t columns_, rows_, blocks_;
};

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
  const Units units(settings);
  Film film(settings.width, settings.height);
  Progress progress(control, units.size());
  const auto cancelled = [&] { return control.cancel != nullptr && control.cancel->load(); };

  parallel_for_dynamic(units.size(), [&](std::size_t i) {
    if (cancelled()) return;
    const Unit unit = units[i];
    TileSums sums(unit.tile);
    paths.render(unit.samples, sums);
    film.merge(sums);
    progress.count_one();
  });
  if (cancelled()) return fail(Errc::interrupted, "", "rendering was interrupted");
  return RenderResult{film.to_image(settings.samples_per_pixel), film.dropped()};
}

}  // namespace dapple
