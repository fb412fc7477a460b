#include "render/classic_paths.h"

#include <algorithm>
#include <vector>

#include "math/random.h"
#include "shading/scatter.h"

namespace dapple {
namespace {

// Which of a sample's decisions a block of four random numbers is for.
constexpr std::uint32_t kCameraDimension = 0;
constexpr std::uint32_t scattering_dimension(int scatterings) {
  return 1 + static_cast<std::uint32_t>(scatterings);
}

}  // namespace

// A path in flight; its ray stands at the same place in the batch.
struct ClassicPaths::Path {
  Vec3f throughput{1, 1, 1};
  int x = 0, y = 0, sample = 0;
  std::uint32_t pixel_index = 0;  // in the tile
};

struct ClassicPaths::Batch {
  std::vector<Path> paths;
  std::vector<Ray> rays;
  std::vector<Hit> hits;

  void keep(std::size_t from, std::size_t to) {
    paths[to] = paths[from];
    rays[to] = rays[from];
  }
  void shrink(std::size_t size) {
    paths.resize(size);
    rays.resize(size);
  }
};

Vec3f sky(const Vec3f& direction) {
  const float t = 0.5f * (normalize(direction).y + 1.0f);
  return (1.0f - t) * Vec3f(1, 1, 1) + t * Vec3f(0.5f, 0.7f, 1.0f);
}

void ClassicPaths::start(SampleRange samples, const Tile& tile, Batch& batch) const {
  for (int sample = samples.begin; sample < samples.end; ++sample) {
    std::uint32_t pixel_index = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const auto u =
            uniform4(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                     static_cast<std::uint32_t>(sample), kCameraDimension, settings_.seed);
        batch.rays.push_back(camera_.generate(x, y, u));
        batch.paths.push_back({{1, 1, 1}, x, y, sample, pixel_index++});
      }
    }
  }
}

// Turns the ray into the scattered one; false when the path was absorbed.
bool ClassicPaths::scatter_path(int scatterings, const Hit& hit, Path& path, Ray& ray) const {
  const SurfacePoint at = scene_.accel().locate(ray, hit);
  const bool from_outside = dot(ray.direction, at.outward) < 0.0f;
  const Vec3f normal = from_outside ? at.outward : -at.outward;
  const auto u = uniform4(static_cast<std::uint32_t>(path.x), static_cast<std::uint32_t>(path.y),
                          static_cast<std::uint32_t>(path.sample),
                          scattering_dimension(scatterings), settings_.seed);
  const auto scattered =
      scatter(scene_.material_of(hit), {normalize(ray.direction), normal, from_outside}, u);
  if (!scattered) return false;
  path.throughput = path.throughput * scattered->attenuation;
  // Starting a little off the surface, on the side the ray leaves to, keeps it from being hit
  // again where single precision puts it on the wrong side.
  const float side = dot(scattered->direction, normal) >= 0.0f ? at.error : -at.error;
  ray.origin = at.position + side * normal;
  ray.direction = scattered->direction;
  return true;
}

void ClassicPaths::scatter_all(int scatterings, Batch& batch, TileSums& sums) const {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < batch.paths.size(); ++i) {
    Path& path = batch.paths[i];
    if (!batch.hits[i].found()) {
      sums.add(path.pixel_index, path.throughput * sky(batch.rays[i].direction));
    } else if (scatter_path(scatterings, batch.hits[i], path, batch.rays[i])) {
      batch.keep(i, kept++);
    }
  }
  batch.shrink(kept);
}

void ClassicPaths::render(SampleRange samples, TileSums& sums) const {
  Batch batch;
  start(samples, sums.tile(), batch);
  for (int scatterings = 0; scatterings < settings_.max_scatterings; ++scatterings) {
    batch.hits.resize(batch.rays.size());
    scene_.accel().intersect(batch.rays, batch.hits);
    scatter_all(scatterings, batch, sums);
  }
  // What is cut contributes white.
  for (const Path& path : batch.paths) sums.add(path.pixel_index, path.throughput);
}

}  // namespace dapple
