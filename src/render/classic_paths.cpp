#include "render/classic_paths.h"

#include <stdexcept>

namespace dapple {
namespace {

void check_size(const PathUnit& unit) {
  if (unit.tile.width() <= kMostColumns && unit.tile.height() <= kMostRows &&
      unit.samples.end - unit.samples.begin <= kMostSamples) {
    return;
  }
  throw std::length_error("more pixels or samples than paths have room to count");
}

}  // namespace

Vec3f sky(const Vec3f& direction) {
  const float t = 0.5f * (direction.y / length(direction) + 1.0f);
  return (1.0f - t) * Vec3f(1, 1, 1) + t * Vec3f(0.5f, 0.7f, 1.0f);
}

void ClassicPaths::render(SampleRange samples, TileOutput& output) const {
  auto batch = batches_.take();
  render(samples, output.colour, *batch);
  batches_.give_back(std::move(batch));
}

void ClassicPaths::render(SampleRange samples, TileSums& sums, PathBatch& batch) const {
  const PathUnit unit = {sums.tile(), samples};
  check_size(unit);
  batch.reserve(static_cast<std::size_t>(unit.tile.pixel_count()) *
                static_cast<std::size_t>(samples.end - samples.begin));
  const PathKernels& kernels = path_kernels();
  const SurfaceView surfaces = scene_.surfaces();
  PathArrays& paths = batch.arrays();
  kernels.start(camera_.frame(), unit, settings_.seed, paths);
  for (int scatterings = 0; scatterings < settings_.max_scatterings; ++scatterings) {
    scene_.accel().intersect({paths.rays, paths.count}, {paths.hits, paths.count});
    kernels.scatter(surfaces, unit, scattering_dimension(scatterings), settings_.seed, paths, sums);
  }
  // What is cut contributes white.
  kernels.cut(paths, sums);
}

}  // namespace dapple
