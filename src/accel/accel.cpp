#include "accel/accel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "accel/linear_accel.h"
#include "accel/median_accel.h"
#include "accel/wide_accel.h"

namespace dapple {
namespace {

constexpr std::array<std::string_view, 3> kAccelNames = {"linear", "median", "fast"};

// The normal is taken from the ray as the centre sees it, which keeps the digits that a position
// far from the origin has lost. A ball so small that none are left gets one that faces the ray.
SurfacePoint locate_on_sphere(const Ray& ray, float t, const Vec3f& centre, float radius) {
  const Vec3f radial = (ray.origin - centre) + t * ray.direction;
  const float squared = dot(radial, radial);
  const bool has_digits = squared >= kSmallestNormal;
  const Vec3f normal = has_digits ? radial / std::sqrt(squared) : -normalize(ray.direction);
  const float size = std::fabs(radius);
  SurfacePoint point;
  point.position = centre + size * normal;  // back onto the sphere: t has the error of its root
  point.outward = radius < 0.0f ? -normal : normal;
  point.error = kPositionError * (max_abs_component(centre) + size);
  return point;
}

SurfacePoint locate_on_rectangle(Vec3f position, RectangleAxes axes, float k) {
  SurfacePoint point;
  position[axes.k] = k;
  point.position = position;
  point.outward[axes.k] = 1.0f;
  point.error = kPositionError * max_abs_component(position);
  return point;
}

}  // namespace

Hit Accel::intersect(const Ray& ray) const {
  Hit hit;
  intersect(std::span(&ray, 1), std::span(&hit, 1));
  return hit;
}

bool Accel::occluded(const Ray& ray) const {
  std::uint8_t result = 0;
  occluded(std::span(&ray, 1), std::span(&result, 1));
  return result != 0;
}

SurfacePoint Accel::locate(const Ray& ray, const Hit& hit) const {
  const auto number = [&](std::size_t k) { return leaf_float(leaf_rows_, hit.lane, k); };
  if (hit.lane.kind() == ShapeKind::sphere) {
    return locate_on_sphere(ray, hit.t, {number(0), number(1), number(2)}, number(3));
  }
  return locate_on_rectangle(ray.at(hit.t), rectangle_axes(hit.lane.kind()), number(4));
}

std::string_view accel_name(AccelKind kind) { return kAccelNames[static_cast<std::size_t>(kind)]; }

Expected<AccelKind> parse_accel_kind(std::string_view name) {
  for (std::size_t i = 0; i < kAccelNames.size(); ++i) {
    if (kAccelNames[i] == name) return static_cast<AccelKind>(i);
  }
  return fail(
      Errc::usage, std::string(name),
      fmt::format("unknown acceleration structure; there are {}", fmt::join(kAccelNames, ", ")));
}

std::unique_ptr<Accel> make_accel(AccelKind kind, const SceneView& scene) {
  switch (kind) {
    case AccelKind::linear:
      return std::make_unique<LinearAccel>(scene);
    case AccelKind::median:
      return std::make_unique<MedianAccel>(scene);
    case AccelKind::fast:
      break;
  }
  return std::make_unique<WideAccel>(scene);
}

}  // namespace dapple
