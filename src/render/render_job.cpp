#include "render/render_job.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>

#include "parallel/parallel.h"
#include "render/camera_rays.h"
#include "render/classic_paths.h"
#include "render/film.h"
#include "render/kernels/path_kernels.h"
#include "render/light_paths.h"

namespace dapple {
namespace {

constexpr int kSmallestTileSide = 32;
constexpr int kSamplesPerUnit = 4;
static_assert(kSamplesPerUnit <= kMostSamples);
// There are at least so many units, unless the picture is too small, for all threads to share.
constexpr std::int64_t kUnitsWanted = 64;

// A pure function of the job: which pixels and which samples.
struct Unit {
  Tile tile;
  SampleRange samples;
};

struct TileSize {
  int width = kSmallestTileSide, height = kSmallestTileSide;

  std::int64_t pixel_count() const { return std::int64_t{width} * height; }
};

// Such that a unit has at most `most_paths`.
TileSize tile_size(const RenderSettings& s, std::int64_t most_paths) {
  const std::int64_t samples = std::min(s.samples_per_pixel, kSamplesPerUnit);
  const std::int64_t pixels = std::int64_t{s.width} * s.height;
  const std::int64_t share = pixels * s.samples_per_pixel / kUnitsWanted;
  const std::int64_t most_pixels = std::min(most_paths, share) / samples;
  TileSize size;
  while (2 * size.pixel_count() <= most_pixels) {
    (size.width <= size.height ? size.width : size.height) *= 2;
  }
  return size;
}

// The units of a job by number: all tiles of the first samples, then of the next.
class Units {
 public:
  Units(const RenderSettings& s, const TileSize& tile)
      : settings_(s),
        tile_(tile),
        columns_(count_of(s.width, tile.width)),
        rows_(count_of(s.height, tile.height)),
        blocks_(count_of(s.samples_per_pixel, kSamplesPerUnit)) {}

  std::size_t size() const { return columns_ * rows_ * blocks_; }
  bool finish_tiles() const { return blocks_ == 1; }

  Unit operator[](std::size_t i) const {
    const auto column = static_cast<int>(i % columns_);
    const auto row = static_cast<int>(i / columns_ % rows_);
    const auto block = static_cast<int>(i / columns_ / rows_);
    const RenderSettings& s = settings_;
    const int x = column * tile_.width, y = row * tile_.height, first = block * kSamplesPerUnit;
    return {{x, y, std::min(x + tile_.width, s.width), std::min(y + tile_.height, s.height)},
            {first, std::min(first + kSamplesPerUnit, s.samples_per_pixel)}};
  }

 private:
  static std::size_t count_of(int whole, int part) {
    return (static_cast<std::size_t>(whole) + static_cast<std::size_t>(part) - 1) /
           static_cast<std::size_t>(part);
  }

  const RenderSettings& settings_;
  TileSize tile_;
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

std::unique_ptr<Integrator> make_integrator(const PreparedScene& scene, const CameraRays& camera,
                                            const RenderSettings& settings) {
  if (scene.lit_or_null() == nullptr) {
    return std::make_unique<ClassicPaths>(scene, camera, settings);
  }
  return std::make_unique<LightPaths>(scene, camera, settings);
}

// The films of one picture.
class Films {
 public:
  Films(const RenderSettings& settings, bool finished_tiles, bool with_alpha)
      : settings_(settings), colour_(make_target(finished_tiles)) {
    if (with_alpha) alpha_ = make_target(finished_tiles);
  }

  TileOutput start(const Tile& tile) const {
    TileOutput output{TileSums(tile), std::nullopt};
    if (alpha_) output.alpha.emplace(tile);
    return output;
  }
  void merge(const TileOutput& output) {
    colour_->merge(output.colour);
    if (alpha_) alpha_->merge(*output.alpha);
    clamped_steps_ += output.clamped_steps;
  }
  RenderResult result() {
    RenderResult result{colour_->to_image(settings_.samples_per_pixel), colour_->dropped(),
                        colour_->cut_count()};
    const double values =
        double{3.0} * settings_.width * settings_.height * settings_.samples_per_pixel;
    result.clamped_radiance =
        static_cast<double>(clamped_steps_.load()) / (double{kFilmStepsPerUnit} * values);
    if (alpha_) {
      for (const Vec3f& pixel : alpha_->to_image(settings_.samples_per_pixel).pixels) {
        result.image.alpha.push_back(pixel.x);
      }
    }
    return result;
  }

 private:
  std::unique_ptr<TileTarget> make_target(bool finished_tiles) const {
    const int width = settings_.width, height = settings_.height;
    if (!finished_tiles) return std::make_unique<Film>(width, height);
    return std::make_unique<FinishedTiles>(width, height, settings_.samples_per_pixel);
  }

  const RenderSettings& settings_;
  std::unique_ptr<TileTarget> colour_, alpha_;
  std::atomic<std::int64_t> clamped_steps_{0};
};

}  // namespace

Expected<RenderResult> render(const PreparedScene& scene, const RenderSettings& settings,
                              const RenderControl& control) {
  if (auto status = validate(settings); !status) return tl::unexpected(status.error());
  const auto camera = CameraRays::create(scene.camera(), settings);
  if (!camera) return tl::unexpected(camera.error());
  const auto integrator = make_integrator(scene, *camera, settings);
  const Units units(settings, tile_size(settings, integrator->paths_in_flight()));
  Films films(settings, units.finish_tiles(),
              settings.transparent_background && scene.lit_or_null() != nullptr);
  Progress progress(control, units.size());
  const auto cancelled = [&] { return control.cancel != nullptr && control.cancel->load(); };

  const auto render_unit = [&](std::size_t i) {
    if (cancelled()) return;
    const Unit unit = units[i];
    TileOutput output = films.start(unit.tile);
    integrator->render(unit.samples, output);
    films.merge(output);
    progress.count_one();
  };
  parallel_for_dynamic(units.size(), render_unit, control.thread_times);
  if (cancelled()) return fail(Errc::interrupted, "", "rendering was interrupted");
  return films.result();
}

}  // namespace dapple
