#include "render/camera_rays.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/functions.h"
#include "math/warps.h"

namespace dapple {
namespace {

// Without a lens everything is sharp, and the plane of focus may be anywhere.
double focus_distance_of(const Camera& camera) {
  if (camera.aperture > 0) return camera.focus_distance;
  return std::clamp(camera.focus_distance, kNearestFocus, kFarthestFocus);
}

double focus_plane_height(const Camera& camera, double focus_distance) {
  if (camera.orthographic_height > 0) return camera.orthographic_height;
  const SinCos<double> half_fov = sin_cos_turns(camera.vertical_fov / 720.0);
  return 2.0 * (half_fov.sin / half_fov.cos) * focus_distance;
}

}  // namespace

Expected<CameraRays> CameraRays::create(const Camera& camera, const RenderSettings& settings) {
  const Vec3d backward = camera.look_from - camera.look_at;
  const Vec3d sideways = cross(camera.up, backward);
  if (!(length(backward) > 0) || !(length(sideways) > 0)) {
    return fail(Errc::bad_data, "camera", "it looks at its own position or along its up direction");
  }
  const double focus = focus_distance_of(camera);
  if (!(focus >= kNearestFocus && focus <= kFarthestFocus)) {
    return fail(Errc::bad_data, "camera",
                fmt::format("the focus distance of its lens, {:g}, is not from {:g} to {:g}", focus,
                            kNearestFocus, kFarthestFocus));
  }
  const Vec3d w = normalize(backward);
  const Vec3d u = normalize(sideways);
  const Vec3d v = cross(w, u);
  const double pixel = focus_plane_height(camera, focus) / settings.height;
  const double lens_radius = camera.aperture / 2;

  CameraRays rays;
  rays.frame_.origin = Vec3f(camera.look_from);
  rays.frame_.corner =
      Vec3f(-(0.5 * settings.width * pixel) * u + (0.5 * settings.height * pixel) * v - focus * w);
  rays.frame_.per_column = Vec3f(pixel * u);
  rays.frame_.per_row = Vec3f(-pixel * v);
  rays.frame_.lens_u = Vec3f(lens_radius * u);
  rays.frame_.lens_v = Vec3f(lens_radius * v);
  rays.frame_.forward = Vec3f(-focus * w);
  rays.frame_.orthographic = camera.orthographic_height > 0;
  return rays;
}

Ray CameraRays::generate(int x, int y, const std::array<float, 4>& u) const {
  const Vec3f lens = sample_uniform_disc(u[2], u[3]);
  const Vec3f offset = lens.x * frame_.lens_u + lens.y * frame_.lens_v;
  const float column = static_cast<float>(x) + u[0];
  const float row = static_cast<float>(y) + u[1];
  Ray ray;
  const Vec3f target = frame_.corner + column * frame_.per_column + row * frame_.per_row;
  ray.origin = frame_.origin + offset;
  ray.direction = target - offset;
  if (frame_.orthographic) {
    ray.origin = ray.origin + (target - frame_.forward);
    ray.direction = frame_.forward - offset;
  }
  ray.t_min = kRayTMin;
  return ray;
}

}  // namespace dapple
