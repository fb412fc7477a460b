#include "dapple/bench_rays.h"

#include <algorithm>

#include "math/random.h"
#include "math/warps.h"

namespace dapple {
namespace {

constexpr int kTileSide = 32;
constexpr std::uint32_t kBounceDimension = 1;

Ray bounce(const Accel& accel, const Ray& ray, const Hit& hit, const std::array<float, 4>& u) {
  const SurfacePoint at = accel.locate(ray, hit);
  const Vec3f normal = dot(ray.direction, at.outward) < 0.0f ? at.outward : -at.outward;
  Ray result;
  result.origin = at.position + at.error * normal;
  result.direction = sample_cosine_hemisphere(normal, u[0], u[1]);
  result.t_min = kRayTMin;
  return result;
}

}  // namespace

Expected<std::vector<Ray>> make_camera_rays(const Camera& camera, const RenderSettings& settings) {
  const auto generator = CameraRays::create(camera, settings);
  if (!generator) return tl::unexpected(generator.error());
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(settings.width) *
               static_cast<std::size_t>(settings.height));
  const auto add_tile = [&](int x0, int y0) {
    for (int y = y0; y < std::min(y0 + kTileSide, settings.height); ++y) {
      for (int x = x0; x < std::min(x0 + kTileSide, settings.width); ++x) {
        const auto u = uniform4(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0,
                                kCameraDimension, settings.seed);
        rays.push_back(generator->generate(x, y, u));
      }
    }
  };
  for (int y = 0; y < settings.height; y += kTileSide) {
    for (int x = 0; x < settings.width; x += kTileSide) add_tile(x, y);
  }
  return rays;
}

std::vector<Ray> make_bounce_rays(const Accel& accel, const std::vector<Ray>& rays,
                                  std::uint64_t seed) {
  std::vector<Hit> hits(rays.size());
  accel.intersect(rays, hits);
  std::vector<Ray> bounced;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits[i].found()) continue;
    const auto u = uniform4(static_cast<std::uint32_t>(i), 0, 0, kBounceDimension, seed);
    bounced.push_back(bounce(accel, rays[i], hits[i], u));
  }
  return bounced;
}

}  // namespace dapple
