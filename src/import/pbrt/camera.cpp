#include "import/pbrt/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/functions.h"

namespace dapple::pbrt {
namespace {

constexpr double kMaxSide = 1 << 16;

double tangent_of_degrees(double degrees) {
  const auto [s, c] = sin_cos_turns(degrees / 360);
  return s / c;
}

// By bisection: it is needed once a file.
double degrees_of_tangent(double tangent) {
  double low = 0, high = 90;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (tangent_of_degrees(middle) < tangent ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Expected<Film> make_film(const Context&, const Params& params) {
  Film film;
  const double width = params.number("xresolution", film.width);
  const double height = params.number("yresolution", film.height);
  if (!(width >= 1 && width <= kMaxSide && height >= 1 && height <= kMaxSide)) {
    return fail(Errc::bad_data, params.place(),
                fmt::format("a film of {} x {} pixels", width, height));
  }
  film.width = static_cast<int>(width);
  film.height = static_cast<int>(height);
  return film;
}

bool is_left_handed(const Transformd& camera_from_world) {
  return determinant(camera_from_world) > 0;
}

Camera make_camera(const Context& context, const Transformd& camera_from_world,
                   const std::string& kind, const Params& params, const Film& film) {
  const Transformd to_scene = context.to_scene * inverse(camera_from_world);
  const Vec3d up = to_scene.vector(Vec3d(0, 1, 0)), forward = to_scene.vector(Vec3d(0, 0, 1));
  Camera camera;
  camera.look_from = to_scene.point(Vec3d());
  camera.look_at = camera.look_from + normalize(forward);
  camera.up = normalize(up);
  // A field of view counts across the shorter side.
  const double shape = film.width < film.height ? double(film.height) / film.width : 1;
  const double half = 0.5 * std::clamp(params.number("fov", 90), 0.01, 179.9);
  const double tangent = tangent_of_degrees(half) * shape * length(up) / length(forward);
  camera.vertical_fov = std::clamp(2 * degrees_of_tangent(tangent), 1e-3, 179.9);
  camera.aperture = 2 * std::max(0.0, params.number("lensradius", 0)) * length(up);
  const double focus = params.number("focaldistance", 1e6) * length(forward);
  camera.focus_distance = focus > 0 ? focus : 1;
  if (kind == "orthographic") {
    camera.orthographic_height = 2 * shape * length(up);
  } else if (kind != "perspective") {
    context.warn(params.place(),
                 fmt::format("the camera '{:.40}' is taken for 'perspective'", kind));
  }
  for (const char* ignored : {"shutteropen", "shutterclose"}) params.find(ignored, {"float"});
  context.warn_of_unused(params);
  return camera;
}

}  // namespace dapple::pbrt
