#include "render/sight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/camera_rays.h"

namespace dapple {
namespace {

constexpr int kCoarseStep = 16;
constexpr double kMostRays = 1 << 20;

// Tries every `step`th pixel of every `step`th row.
bool any_hit(const PreparedScene& scene, const RenderSettings& settings, const CameraRays& rays,
             int step) {
  std::vector<Ray> row;
  std::vector<std::uint8_t> occluded;
  for (int y = step / 2; y < settings.height; y += step) {
    row.clear();
    for (int x = step / 2; x < settings.width; x += step) {
      Ray ray = rays.generate(x, y, {0.5f, 0.5f, 0.5f, 0.5f});
      const float unit = length(ray.direction);
      ray.direction = ray.direction / unit;
      // As renderings do: light paths see all that is before the camera.
      ray.t_min = scene.lit_or_null() != nullptr ? 0 : kRayTMin * unit;
      row.push_back(ray);
    }
    occluded.assign(row.size(), 0);
    scene.accel().occluded(row, occluded);
    if (std::ranges::any_of(occluded, [](std::uint8_t hit) { return hit != 0; })) return true;
  }
  return false;
}

// Whether the nearest surface of a body with a medium is met from within.
bool leaves_medium(const PreparedScene& scene, Ray ray) {
  constexpr int kMostSurfaces = 64;  // in front of that of the body
  const LitScene& lit = scene.lit();
  for (int i = 0; i < kMostSurfaces; ++i) {
    const Hit hit = scene.accel().intersect(ray);
    if (!hit.found()) return false;
    if (!lit.materials().interior(lit.surfaces().material_of(hit)).is_vacuum()) {
      return dot(scene.accel().locate(ray, hit).outward, ray.direction) > 0;
    }
    ray.t_min = std::nextafter(hit.t * (1 + kTrianglePositionError), ray.t_max);
  }
  return false;
}

}  // namespace

bool stands_in_medium(const PreparedScene& scene) {
  if (scene.lit_or_null() == nullptr) return false;
  // Not along the axes themselves, where the seams of bodies often lie.
  const Vec3f directions[] = {{1, 0.11f, 0.07f}, {0.07f, 1, 0.11f}, {0.11f, 0.07f, 1}};
  for (const Vec3f& direction : directions) {
    for (const float sign : {1.0f, -1.0f}) {
      Ray ray;
      ray.origin = Vec3f(scene.camera().look_from);
      ray.direction = sign * direction;
      if (!leaves_medium(scene, ray)) return false;
    }
  }
  return true;
}

bool sees_surfaces(const PreparedScene& scene, const RenderSettings& settings) {
  const auto rays = CameraRays::create(scene.camera(), settings);
  if (!rays) return false;
  const double pixels = double(settings.width) * settings.height;
  const int fine = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostRays))));
  return any_hit(scene, settings, *rays, kCoarseStep) || any_hit(scene, settings, *rays, fine);
}

}  // namespace dapple
