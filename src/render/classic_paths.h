// The classic light transport: paths of at most a few scatterings under a blue sky.
//
// A tile's paths advance together, one scattering at a time, so that every generation of rays is
// one stream for the acceleration structure and for the kernels between traversals.
#pragma once

#include "render/camera_rays.h"
#include "render/idle_pool.h"
#include "render/integrator.h"
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

class ClassicPaths : public Integrator {
 public:
  ClassicPaths(const PreparedScene& scene, const CameraRays& camera, const RenderSettings& settings)
      : scene_(scene), camera_(camera), settings_(settings) {}

  void render(SampleRange samples, TileOutput& output) const override;
  std::int64_t paths_in_flight() const override { return 8192; }

 private:
  void render(SampleRange samples, TileSums& sums, PathBatch& batch) const;

  const PreparedScene& scene_;
  const CameraRays& camera_;
  const RenderSettings& settings_;
  mutable IdlePool<PathBatch> batches_;
};

}  // namespace dapple
