#include "render/framing.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"

namespace dapple {
namespace {

constexpr double kMargin = 1.05;  // of the size, around the object

bool is_empty(const Bounds3f& b) { return !(b.lo.x <= b.hi.x); }

double tangent(double degrees) {
  const SinCos<double> angle = sin_cos_turns(degrees / 360);
  return angle.sin / angle.cos;
}

Vec3d corner_of(const Bounds3f& b, int i) {
  return {i & 1 ? b.hi.x : b.lo.x, i & 2 ? b.hi.y : b.lo.y, i & 4 ? b.hi.z : b.lo.z};
}

// How far from the centre a camera that looks along -`backward` must stand for all corners to lie
// within its pyramid.
double distance_for(const Bounds3f& bounds, const Vec3d& centre, const Vec3d& backward,
                    double tan_x, double tan_y) {
  const Vec3d right = normalize(cross(Vec3d(0, 1, 0), backward));
  const Vec3d up = cross(backward, right);
  double distance = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3d corner = kMargin * (corner_of(bounds, i) - centre);
    const double across =
        std::fmax(std::fabs(dot(corner, right)) / tan_x, std::fabs(dot(corner, up)) / tan_y);
    distance = std::fmax(distance, across + dot(corner, backward));
  }
  return distance;
}

Vec3d direction_of(double theta, double phi) {
  const SinCos<double> t = sin_cos_turns(theta / 360), p = sin_cos_turns(phi / 360);
  return {p.sin * t.sin, p.cos, p.sin * t.cos};
}

}  // namespace

Camera orbit_camera(const Orbit& orbit, const Vec3d& target, double vertical_fov) {
  // Straight up or down, the camera still needs to know where the picture's top is.
  const double phi = std::clamp(orbit.phi, 1e-4, 180 - 1e-4);
  Camera camera;
  camera.look_at = target;
  camera.look_from = target + orbit.radius * direction_of(orbit.theta, phi);
  camera.vertical_fov = vertical_fov;
  camera.aperture = 0;
  camera.focus_distance = orbit.radius;
  return camera;
}

Camera frame_scene(const Bounds3f& bounds, double width_over_height, double vertical_fov) {
  Orbit orbit;
  Vec3d centre;
  if (!is_empty(bounds)) {
    centre = 0.5 * (Vec3d(bounds.lo) + Vec3d(bounds.hi));
    const double tan_y = tangent(vertical_fov / 2);
    const double needed = distance_for(bounds, centre, direction_of(orbit.theta, orbit.phi),
                                       tan_y * width_over_height, tan_y);
    if (needed > 0) orbit.radius = needed;
  }
  return orbit_camera(orbit, centre, vertical_fov);
}

}  // namespace dapple
