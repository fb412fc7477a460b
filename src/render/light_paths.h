// Light transport for models: path tracing with next-event estimation and multiple importance
// sampling [VeachG95], Russian roulette, participating media inside closed surfaces.
//
// As in classic_paths.h a tile's paths advance together, so that every generation of rays and of
// shadow rays is one stream for the acceleration structure.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/camera_rays.h"
#include "render/idle_pool.h"
#include "render/integrator.h"
#include "render/kernels/light_kernels.h"
#include "render/light_path.h"
#include "render/path_sampler.h"
#include "render/path_vertex.h"
#include "render/prepared_scene.h"
#include "render/settings.h"

namespace dapple {

class LightPaths : public Integrator {
 public:
  // The arguments must outlive this; the scene must have its lit part.
  LightPaths(const PreparedScene& scene, const CameraRays& camera, const RenderSettings& settings);

  void render(SampleRange samples, TileOutput& output) const override;
  std::int64_t paths_in_flight() const override { return 4096; }

 private:
  // The paths of one unit of work: element i of each of the first three belongs to one path.
  struct Batch {
    std::vector<LightPath> paths;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<ShadowRay> shadow_rays;
    std::vector<Ray> occlusion_rays;
    std::vector<Hit> occlusion_hits;
    std::vector<std::uint8_t> occluded;
    std::vector<std::uint8_t> goes_on;
    // Paths by number, in the order of the elements of a chunk.
    std::array<std::uint32_t, kChunk> members;
    std::size_t member_count = 0;
    StartChunk starts;
    VertexChunk vertices;
    EscapeChunk escapes;
    SurfaceChunk surfaces;
    PendingVertices pending;
  };

  void start(SampleRange samples, const Tile& tile, Batch& batch) const;
  void start_chunk(std::size_t count, const Tile& tile, Batch& batch) const;
  void let_escape(const PathVertices& vertices, Batch& batch) const;
  void see_environment(const PathVertices& vertices, Batch& batch) const;
  void advance_others(const PathVertices& vertices, Batch& batch) const;
  void advance_members(const PathVertices& vertices, Batch& batch) const;
  void draw(Batch& batch) const;
  void describe(Batch& batch) const;
  void finish_pending(const PathVertices& vertices, Batch& batch) const;
  void shade(Batch& batch, TileOutput& output) const;
  void trace_shadow_rays(Batch& batch) const;
  void pass_transparent_surfaces(Batch& batch) const;
  void arrive(const ShadowRay& shadow, Batch& batch) const;
  bool pass_one(const LitScene& lit, const Hit& hit, ShadowRay& shadow) const;
  void finish(const LightPath& path, TileOutput& output) const;

  const PreparedScene& scene_;
  const CameraRays& camera_;
  const RenderSettings& settings_;
  PathSampler sampler_;
  PixelFilter filter_;
  const LightKernels& kernels_;
  std::optional<EnvironmentView> environment_;  // if vectors can look it up
  float pixel_spread_ = 0;                      // growth of a primary ray's cone along it
  float pixel_width_ = 0;                       // its width at the camera
  mutable IdlePool<Batch> batches_;
};

}  // namespace dapple
