#include "render/light_paths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/lit_scene.h"
#include "render/path_vertex.h"

namespace dapple {
namespace {

// Surfaces that a shadow ray may pass through.
constexpr int kMaxShadowPassages = 32;
// The rays of 64 paths in a row should go much the same way, see kStripColumns;
// of meshes, squares of eight columns are as fast.
constexpr int kColumns = 16;

bool escapes(const LightPath& path, const Hit& hit) {
  return !hit.found() && path.insides.innermost() == kVacuum;
}

}  // namespace

LightPaths::LightPaths(const PreparedScene& scene, const CameraRays& camera,
                       const RenderSettings& settings)
    : scene_(scene),
      camera_(camera),
      settings_(settings),
      sampler_(settings.samples_per_pixel, settings.seed),
      filter_(settings.filter),
      kernels_(light_kernels()),
      environment_(scene.lit().lights().environment().view()) {
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
  StartChunk& chunk = batch.starts;
  std::size_t count = 0;
  for (int x = tile.x0; x < tile.x1; x += kColumns) {
    const int end = std::min(x + kColumns, tile.x1);
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int sample = samples.begin; sample < samples.end; ++sample) {
        for (int column = x; column < end; ++column) {
          chunk.x[count] = static_cast<std::uint32_t>(column);
          chunk.y[count] = static_cast<std::uint32_t>(y);
          chunk.sample[count] = static_cast<std::uint32_t>(sample);
          if (++count < kChunk) continue;
          start_chunk(count, tile, batch);
          count = 0;
        }
      }
    }
  }
  start_chunk(count, tile, batch);
}

void LightPaths::start_chunk(std::size_t count, const Tile& tile, Batch& batch) const {
  const StartChunk& chunk = batch.starts;
  kernels_.start(sampler_.view(), filter_.view(), camera_.frame(), count, batch.starts);
  const auto x0 = static_cast<std::uint32_t>(tile.x0), y0 = static_cast<std::uint32_t>(tile.y0);
  const auto width = static_cast<std::uint32_t>(tile.width());
  for (std::size_t i = 0; i < count; ++i) {
    LightPath& path = batch.paths.emplace_back();
    path.sample = {chunk.block[i], chunk.position[i]};
    path.pixel = (chunk.y[i] - y0) * width + (chunk.x[i] - x0);
    path.cone_width = pixel_width_;
    path.cone_spread = pixel_spread_;
    path.dispersion.channel = static_cast<int>(chunk.channel[i]);
    Ray& ray = batch.rays.emplace_back();
    ray.origin = {chunk.origin[0][i], chunk.origin[1][i], chunk.origin[2][i]};
    ray.direction = {chunk.direction[0][i], chunk.direction[1][i], chunk.direction[2][i]};
    ray.t_min = 0;
  }
}

void LightPaths::shade(Batch& batch, TileOutput& output) const {
  const PathVertices vertices(scene_, sampler_, settings_);
  batch.shadow_rays.clear();
  const std::size_t count = batch.paths.size();
  batch.goes_on.assign(count, 0);
  let_escape(vertices, batch);
  advance_others(vertices, batch);
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

// Paths that leave the scene see the environment.
void LightPaths::let_escape(const PathVertices& vertices, Batch& batch) const {
  batch.member_count = 0;
  for (std::uint32_t i = 0; i < batch.paths.size(); ++i) {
    const LightPath& path = batch.paths[i];
    if (!escapes(path, batch.hits[i]) || !vertices.sees_environment(path)) continue;
    batch.members[batch.member_count++] = i;
    if (batch.member_count == kChunk) see_environment(vertices, batch);
  }
  see_environment(vertices, batch);
}

void LightPaths::see_environment(const PathVertices& vertices, Batch& batch) const {
  EscapeChunk& chunk = batch.escapes;
  const std::size_t count = std::exchange(batch.member_count, 0);
  const EnvironmentLight& light = scene_.lit().lights().environment();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f& d = batch.rays[batch.members[i]].direction;
    for (int axis = 0; axis < 3; ++axis) chunk.direction[axis][i] = d[axis];
    if (environment_) continue;
    const Vec3f radiance = light.radiance(d);
    for (int axis = 0; axis < 3; ++axis) chunk.radiance[axis][i] = radiance[axis];
    chunk.pdf[i] = light.pdf(d);
  }
  if (environment_) kernels_.see_environment(*environment_, count, chunk);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f radiance{chunk.radiance[0][i], chunk.radiance[1][i], chunk.radiance[2][i]};
    vertices.escape(radiance, chunk.pdf[i], batch.paths[batch.members[i]]);
  }
}

void LightPaths::advance_others(const PathVertices& vertices, Batch& batch) const {
  batch.member_count = 0;
  for (std::uint32_t i = 0; i < batch.paths.size(); ++i) {
    if (escapes(batch.paths[i], batch.hits[i])) continue;
    batch.members[batch.member_count++] = i;
    if (batch.member_count == kChunk) advance_members(vertices, batch);
  }
  advance_members(vertices, batch);
}

void LightPaths::advance_members(const PathVertices& vertices, Batch& batch) const {
  draw(batch);
  describe(batch);
  std::size_t described = 0;
  const VertexChunk& chunk = batch.vertices;
  const std::size_t count = std::exchange(batch.member_count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    VertexDraw drawn;
    for (std::size_t k = 0; k < 4; ++k) drawn.choose[k] = chunk.choose[k][i];
    for (std::size_t k = 0; k < 4; ++k) drawn.move[k] = chunk.move[k][i];
    drawn.environment = {
        {chunk.light_direction[0][i], chunk.light_direction[1][i], chunk.light_direction[2][i]},
        {chunk.light_radiance[0][i], chunk.light_radiance[1][i], chunk.light_radiance[2][i]},
        chunk.light_pdf[i]};
    const std::uint32_t at = batch.members[i];
    Described surface{batch.surfaces, std::nullopt};
    if (scene_.lit().surfaces().fits_chunk(batch.hits[at])) surface.element = described++;
    batch.goes_on[at] = vertices.advance(at, batch.paths[at], batch.rays[at], batch.hits[at],
                                         surface, drawn, batch.shadow_rays, batch.pending);
  }
  finish_pending(vertices, batch);
}

// The surfaces that members hit, as far as they fit, one after the other.
void LightPaths::describe(Batch& batch) const {
  const SurfaceBuilder& surfaces = scene_.lit().surfaces();
  std::size_t count = 0;
  for (std::size_t i = 0; i < batch.member_count; ++i) {
    const std::uint32_t at = batch.members[i];
    if (!surfaces.fits_chunk(batch.hits[at])) continue;
    surfaces.put(batch.rays[at], batch.hits[at], count++, batch.surfaces);
  }
  kernels_.describe(surfaces.mesh(scene_.accel()), count, batch.surfaces);
}

void LightPaths::finish_pending(const PathVertices& vertices, Batch& batch) const {
  PendingVertices& pending = batch.pending;
  kernels_.shade(albedo_pairs(), pending.count, pending.chunk);
  for (std::size_t i = 0; i < pending.count; ++i) {
    const std::uint32_t at = pending.vertices[i].path;
    batch.goes_on[at] =
        vertices.finish(pending, i, batch.paths[at], batch.rays[at], batch.shadow_rays);
  }
  pending.count = 0;
}

// The random numbers of the members' vertices, and what they choose of the environment.
void LightPaths::draw(Batch& batch) const {
  VertexChunk& chunk = batch.vertices;
  for (std::size_t i = 0; i < batch.member_count; ++i) {
    const LightPath& path = batch.paths[batch.members[i]];
    chunk.block[i] = path.sample.block;
    chunk.position[i] = path.sample.reversed_position;
    chunk.dimension[i] = dimension_of(path, Decision::choose);
  }
  kernels_.draw(sampler_.view(), batch.member_count, chunk);
  if (environment_) {
    kernels_.sample_environment(*environment_, batch.member_count, chunk);
    return;
  }
  const EnvironmentLight& light = scene_.lit().lights().environment();
  for (std::size_t i = 0; i < batch.member_count; ++i) {
    const EnvironmentSample found = light.sample({chunk.move[2][i], chunk.move[3][i]});
    for (int k = 0; k < 3; ++k) {
      chunk.light_direction[k][i] = found.direction[k];
      chunk.light_radiance[k][i] = found.radiance[k];
    }
    chunk.light_pdf[i] = found.pdf;
  }
}

// Most arrive. Whether anything is in the way is found faster than what that is.
void LightPaths::trace_shadow_rays(Batch& batch) const {
  auto& shadows = batch.shadow_rays;
  batch.occlusion_rays.resize(shadows.size());
  batch.occluded.resize(shadows.size());
  for (std::size_t i = 0; i < shadows.size(); ++i) batch.occlusion_rays[i] = shadows[i].ray;
  scene_.accel().occluded(batch.occlusion_rays, batch.occluded);
  std::size_t rest = 0;
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    if (!batch.occluded[i]) {
      arrive(shadows[i], batch);
    } else {
      shadows[rest++] = shadows[i];
    }
  }
  shadows.resize(rest);
  if (scene_.lit().has_transparency()) pass_transparent_surfaces(batch);
}

// Moves the rest past what lets light through and takes from its contribution what that held back,
// until it arrives or nothing is left of it.
void LightPaths::pass_transparent_surfaces(Batch& batch) const {
  auto& shadows = batch.shadow_rays;
  for (int passage = 0; passage <= kMaxShadowPassages && !shadows.empty(); ++passage) {
    batch.occlusion_rays.resize(shadows.size());
    batch.occlusion_hits.resize(shadows.size());
    for (std::size_t i = 0; i < shadows.size(); ++i) batch.occlusion_rays[i] = shadows[i].ray;
    scene_.accel().intersect(batch.occlusion_rays, batch.occlusion_hits);
    std::size_t open = 0;  // those before are not decided yet
    for (std::size_t i = 0; i < shadows.size(); ++i) {
      const Hit& hit = batch.occlusion_hits[i];
      if (!hit.found()) {
        arrive(shadows[i], batch);
      } else if (pass_one(scene_.lit(), hit, shadows[i])) {
        shadows[open++] = shadows[i];
      }
    }
    shadows.resize(open);
  }
}

void LightPaths::arrive(const ShadowRay& shadow, Batch& batch) const {
  batch.paths[shadow.path].add(shadow.contribution, shadow.indirect, settings_.clamp_indirect);
}

bool LightPaths::pass_one(const LitScene& lit, const Hit& hit, ShadowRay& shadow) const {
  const MaterialId material = lit.surfaces().material_of(hit);
  if (!lit.materials().may_be_transparent(material)) return false;
  const Surface surface = lit.surfaces().build(scene_.accel(), shadow.ray, hit, 0);
  const float passing = 1 - lit.materials().opacity(material, surface.at);
  if (!(passing > 0)) return false;
  shadow.contribution = passing * shadow.contribution;
  shadow.ray.origin = leave_surface(place_of(surface), shadow.ray.direction);
  shadow.ray.t_max -= hit.t;
  return true;
}

void LightPaths::finish(const LightPath& path, TileOutput& output) const {
  if (path.alpha == 0) return;
  output.colour.add(path.pixel, path.radiance);
  if (output.alpha) output.alpha->add(path.pixel, {path.alpha, 0, 0});
  output.clamped_steps += static_cast<std::int64_t>(
      static_cast<double>(std::min(path.clamped, kFilmClamp) * kFilmStepsPerUnit));
}

}  // namespace dapple
