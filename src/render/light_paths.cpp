#include "render/light_paths.h"

#include <algorithm>
#include <cmath>

#include "math/sobol.h"
#include "render/lit_scene.h"
#include "render/path_vertex.h"

namespace dapple {
namespace {

// Surfaces that a shadow ray may pass through.
constexpr int kMaxShadowPassages = 32;
// The rays of 64 paths in a row should go much the same way, see start_paths in camera-inl.h.
constexpr int kColumns = 16;

}  // namespace

LightPaths::LightPaths(const PreparedScene& scene, const CameraRays& camera,
                       const RenderSettings& settings)
    : scene_(scene),
      camera_(camera),
      settings_(settings),
      sampler_(settings.samples_per_pixel, settings.seed),
      filter_(settings.filter) {
  const CameraFrame& frame = camera.frame();
  const bool parallel = frame.orthographic;
  pixel_spread_ = parallel ? 0.0f : length(frame.per_row) / length(frame.forward);
  pixel_width_ = parallel ? length(frame.per_row) : 0.0f;
}

void LightPaths::render(SampleRange samples, TileOutput& output) const {
  auto batch = batches_.take();
  start(samples, output.colour.tile(), *batch);
  while (!batch->paths.empty()) {
    batch->hits.resize(batch->rays.size());
    scene_.accel().intersect(batch->rays, batch->hits);
    shade(*batch, output);
  }
  batches_.give_back(std::move(batch));
}

void LightPaths::start(SampleRange samples, const Tile& tile, Batch& batch) const {
  batch.paths.clear();
  batch.rays.clear();
  for (int x = tile.x0; x < tile.x1; x += kColumns) {
    const int end = std::min(x + kColumns, tile.x1);
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int sample = samples.begin; sample < samples.end; ++sample) {
        for (int column = x; column < end; ++column) {
          start_one(column, y, sample, tile, batch);
        }
      }
    }
  }
}

void LightPaths::start_one(int x, int y, int sample, const Tile& tile, Batch& batch) const {
  LightPath path;
  path.sample = sampler_.place(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                               static_cast<std::uint32_t>(sample));
  path.pixel = static_cast<std::uint32_t>((y - tile.y0) * tile.width() + (x - tile.x0));
  path.cone_width = pixel_width_;
  path.cone_spread = pixel_spread_;
  auto u = sampler_.uniform4(path.sample, static_cast<std::uint32_t>(Decision::camera));
  u[0] = filter_.place(u[0]);
  u[1] = filter_.place(u[1]);
  Ray ray = camera_.generate(x, y, u);
  ray.t_min = 0;
  ray.direction = normalize(ray.direction);
  path.dispersion.channel =
      static_cast<int>(mix(path.sample.block, path.sample.reversed_position) % 3);
  batch.paths.push_back(path);
  batch.rays.push_back(ray);
}

void LightPaths::shade(Batch& batch, TileOutput& output) const {
  const PathVertices vertices(scene_, sampler_, settings_);
  batch.shadow_rays.clear();
  const auto count = static_cast<std::uint32_t>(batch.paths.size());
  batch.goes_on.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    batch.goes_on[i] =
        vertices.advance(i, batch.paths[i], batch.rays[i], batch.hits[i], batch.shadow_rays);
  }
  trace_shadow_rays(batch);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!batch.goes_on[i]) {
      finish(batch.paths[i], output);
      continue;
    }
    batch.paths[kept] = batch.paths[i];
    batch.rays[kept++] = batch.rays[i];
  }
  batch.paths.resize(kept);
  batch.rays.resize(kept);
}

void LightPaths::trace_shadow_rays(Batch& batch) const {
  if (scene_.lit().has_transparency()) pass_transparent_surfaces(batch);
  const std::size_t count = batch.shadow_rays.size();
  batch.occlusion_rays.resize(count);
  batch.occluded.resize(count);
  for (std::size_t i = 0; i < count; ++i) batch.occlusion_rays[i] = batch.shadow_rays[i].ray;
  scene_.accel().occluded(batch.occlusion_rays, batch.occluded);
  for (std::size_t i = 0; i < count; ++i) {
    if (batch.occluded[i]) continue;
    const ShadowRay& shadow = batch.shadow_rays[i];
    batch.paths[shadow.path].add(shadow.contribution, shadow.indirect, settings_.clamp_indirect);
  }
}

// Moves every shadow ray past what lets light through and takes from its contribution what that
// held back; drops those that nothing is left of.
void LightPaths::pass_transparent_surfaces(Batch& batch) const {
  const LitScene& lit = scene_.lit();
  auto& shadows = batch.shadow_rays;
  std::size_t open = shadows.size();  // those before are not decided yet
  for (int passage = 0; passage < kMaxShadowPassages && open > 0; ++passage) {
    batch.occlusion_rays.resize(open);
    batch.occlusion_hits.resize(open);
    for (std::size_t i = 0; i < open; ++i) batch.occlusion_rays[i] = shadows[i].ray;
    scene_.accel().intersect(batch.occlusion_rays, batch.occlusion_hits);
    for (std::size_t i = open; i-- > 0;) {
      const Hit& hit = batch.occlusion_hits[i];
      const bool passes = hit.found() && pass_one(lit, hit, shadows[i]);
      if (passes) continue;
      // Decided: it meets nothing more, or nothing is left of it.
      if (hit.found()) shadows[i].contribution = {};
      std::swap(shadows[i], shadows[--open]);
    }
  }
  std::erase_if(shadows, [](const ShadowRay& s) { return s.contribution == Vec3f(); });
}

bool LightPaths::pass_one(const LitScene& lit, const Hit& hit, ShadowRay& shadow) const {
  const MaterialId material = lit.surfaces().material_of(hit);
  if (!lit.materials().may_be_transparent(material)) return false;
  const Surface surface = lit.surfaces().build(scene_.accel(), shadow.ray, hit, 0);
  const float passing = 1 - lit.materials().opacity(material, surface.at);
  if (!(passing > 0)) return false;
  shadow.contribution = passing * shadow.contribution;
  shadow.ray.origin = leave_surface(surface, shadow.ray.direction);
  shadow.ray.t_max -= hit.t;
  return true;
}

void LightPaths::finish(const LightPath& path, TileOutput& output) const {
  output.colour.add(path.pixel, path.radiance);
  if (output.alpha) output.alpha->add(path.pixel, {path.alpha, 0, 0});
  output.clamped_steps += static_cast<std::int64_t>(
      static_cast<double>(std::min(path.clamped, kFilmClamp) * kFilmStepsPerUnit));
}

}  // namespace dapple
