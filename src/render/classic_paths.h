// The classic light transport: paths of at most a few scatterings under a blue sky.
//
// A tile's paths advance together, one scattering at a time, so that every generation of rays is
// one stream for the acceleration structure.
#pragma once

#include "render/camera_rays.h"
#include "render/film.h"
#include "render/prepared_scene.h"
#include "render/settings.h"

namespace dapple {

// Samples [begin, end) of every pixel.
struct SampleRange {
  int begin = 0;
  int end = 0;
};

// The sky that a ray of direction d sees: white below, blue above.
[[nodiscard]] Vec3f sky(const Vec3f& direction);

class ClassicPaths {
 public:
  ClassicPaths(const PreparedScene& scene, const CameraRays& camera, const RenderSettings& settings)
      : scene_(scene), camera_(camera), settings_(settings) {}

  // Adds the samples of the range to every pixel of the sums' tile.
  void render(SampleRange samples, TileSums& sums) const;

 private:
  struct Path;
  struct Batch;

  void start(SampleRange samples, const Tile& tile, Batch& batch) const;
  void scatter_all(int scatterings, Batch& batch, TileSums& sums) const;
  bool scatter_path(int scatterings, const Hit& hit, Path& path, Ray& ray) const;

  const PreparedScene& scene_;
  const CameraRays& camera_;
  const RenderSettings& settings_;
};

}  // namespace dapple
