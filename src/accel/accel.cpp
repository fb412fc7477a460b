#include "accel/accel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "accel/intersect_scalar.h"
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

SurfacePoint locate_on_triangle(const Ray& input, const float* v) {
  const PreparedRay ray = prepare(input);
  const TriangleWeights weights = weigh_triangle(ray, v);
  const float scale = 1.0f / weights.sum;
  const Vec3f a(v[0], v[1], v[2]), b(v[3], v[4], v[5]), c(v[6], v[7], v[8]);
  const Vec3f to_b = b - a, to_c = c - a;
  SurfacePoint point;
  point.u = weights.of[1] * scale;
  point.v = weights.of[2] * scale;
  point.position = (a + point.u * to_b) + point.v * to_c;
  // Of edges of about unit length, so that small triangles keep their digits.
  const float size = 1.0f / larger(max_abs_component(to_b), max_abs_component(to_c));
  const Vec3f normal = cross(size * to_b, size * to_c);
  const float squared = dot(normal, normal);
  const bool has_digits = squared >= kSmallestNormal;
  point.outward = has_digits ? normal / std::sqrt(squared) : -normalize(input.direction);
  point.error = kTrianglePositionError *
                larger(larger(max_abs_component(a), max_abs_component(b)), max_abs_component(c));
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
  if (hit.lane.kind() == ShapeKind::triangle) {
    float vertices[9];
    for (std::size_t i = 0; i < 9; ++i) vertices[i] = number(i);
    return locate_on_triangle(ray, vertices);
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
