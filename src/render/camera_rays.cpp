#include "render/camera_rays.h"

#include "math/functions.h"
#include "math/warps.h"

namespace dapple {

Expected<CameraRays> CameraRays::create(const Camera& camera, const RenderSettings& settings) {
  const SinCos<double> half_fov = sin_cos_turns(camera.vertical_fov / 720.0);
  const double half_height = half_fov.sin / half_fov.cos;
  const Vec3d backward = camera.look_from - camera.look_at;
  const Vec3d sideways = cross(camera.up, backward);
  if (!(length(backward) > 0) || !(length(sideways) > 0)) {
    return fail(Errc::bad_data, "camera", "it looks at its own position or along its up direction");
  }
  const Vec3d w = normalize(backward);
  const Vec3d u = normalize(sideways);
  const Vec3d v = cross(w, u);
  const double pixel = 2.0 * half_height * camera.focus_distance / settings.height;
  const double lens_radius = camera.aperture / 2;

  CameraRays rays;
  rays.origin_ = Vec3f(camera.look_from);
  rays.corner_ = Vec3f(-(0.5 * settings.width * pixel) * u + (0.5 * settings.height * pixel) * v -
                       camera.focus_distance * w);
  rays.per_column_ = Vec3f(pixel * u);
  rays.per_row_ = Vec3f(-pixel * v);
  rays.lens_u_ = Vec3f(lens_radius * u);
  rays.lens_v_ = Vec3f(lens_radius * v);
  return rays;
}

Ray CameraRays::generate(int x, int y, const std::array<float, 4>& u) const {
  const Vec3f lens = sample_uniform_disc(u[2], u[3]);
  const Vec3f offset = lens.x * lens_u_ + lens.y * lens_v_;
  const float column = static_cast<float>(x) + u[0];
  const float row = static_cast<float>(y) + u[1];
  Ray ray;
  ray.origin = origin_ + offset;
  ray.direction = corner_ + column * per_column_ + row * per_row_ - offset;
  ray.t_min = kRayTMin;
  return ray;
}

}  // namespace dapple
