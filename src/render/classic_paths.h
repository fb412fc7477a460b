// The classic light transport: paths of at most a few scatterings under a blue sky.
//
// A tile's paths advance together, one scattering at a time, so that every generation of rays is
// one stream for the acceleration structure and for the kernels between traversals.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "render/camera_rays.h"
#include "render/film.h"
#include "render/path_batch.h"
#include "render/prepared_scene.h"
#include "render/settings.h"

namespace dapple {

// The block of four random numbers that a path's scattering after `scatterings` others uses.
constexpr std::uint32_t scattering_dimension(int scatterings) {
  return kCameraDimension + 1 + static_cast<std::uint32_t>(scatterings);
}

// The sky that a ray of direction d sees: white below, blue above.
[[nodiscard]] Vec3f sky(const Vec3f& direction);

class ClassicPaths {
 public:
  ClassicPaths(const PreparedScene& scene, const CameraRays& camera, const RenderSettings& settings)
      : scene_(scene), camera_(camera), settings_(settings) {}

  // Adds the samples of the range to every pixel of the sums' tile. May be called from many
  // threads at once.
  void render(SampleRange samples, TileSums& sums) const;

 private:
  void render(SampleRange samples, TileSums& sums, PathBatch& batch) const;

  const PreparedScene& scene_;
  const CameraRays& camera_;
  const RenderSettings& settings_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<PathBatch>> idle_;  // memory that no thread uses now
};

}  // namespace dapple
