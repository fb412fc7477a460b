#include "kernels/exact_hit.h"

#include <cmath>
#include <limits>

#include "kernels/surface.h"

namespace dapple::bench {
namespace {

// Embree works with reciprocals of a few units in the last place, and so do sums of products of
// coordinates: sixteen units in the last place of the largest number that went in.
constexpr double kUnits = 16 * 0x1p-24;

// Whether `t` is too near to an end of the ray to say on which side of it single precision is.
bool near_an_end(const Ray& ray, double t, double error) {
  return std::fabs(t - double{ray.t_min}) <= error || std::fabs(t - double{ray.t_max}) <= error;
}

ExactHit judge(const Ray& ray, double t, double error) {
  if (near_an_end(ray, t, error)) return {Verdict::borderline, t, error};
  const bool inside = t >= double{ray.t_min} && t <= double{ray.t_max};
  return {inside ? Verdict::hit : Verdict::miss, t, error};
}

ExactHit exact_sphere(const Ray& ray, const Sphere& sphere) {
  const Vec3d direction(ray.direction);
  const Vec3d from_centre = Vec3d(ray.origin) - Vec3d(Vec3f(sphere.centre));
  const double radius = double{static_cast<float>(sphere.radius)};
  const double squared = dot(direction, direction);
  const double t_mid = -dot(from_centre, direction) / squared;
  const Vec3d nearest = from_centre + t_mid * direction;
  const double discriminant = radius * radius - dot(nearest, nearest);
  // How far single precision may put the ray from where it is.
  const double shift = kUnits * (length(from_centre) + std::fabs(radius));
  const double blur = shift * (2 * std::fabs(radius) + shift);
  if (std::fabs(discriminant) <= blur) return {Verdict::borderline, t_mid, blur};
  if (discriminant < 0) return {Verdict::miss, t_mid, 0};

  const double half = std::sqrt(discriminant / squared);
  const double error =
      half - std::sqrt((discriminant - blur) / squared) + shift / std::sqrt(squared);
  const ExactHit first = judge(ray, t_mid - half, error);
  return first.verdict == Verdict::miss && t_mid - half < double{ray.t_min}
             ? judge(ray, t_mid + half, error)
             : first;
}

ExactHit exact_rectangle(const Ray& ray, RectangleAxes axes, const Rectangle& r) {
  const double slope = std::fabs(double{ray.direction[axes.k]});
  const double t = (double{static_cast<float>(r.k)} - double{ray.origin[axes.k]}) /
                   double{ray.direction[axes.k]};
  const Vec3d position = Vec3d(ray.origin) + t * Vec3d(ray.direction);
  const double shift =
      kUnits * (max_abs_component(position) + max_abs_component(Vec3d(ray.origin)));
  const double error = shift / slope;
  const double margin = std::fmin(std::fmin(position[axes.u] - r.u0, r.u1 - position[axes.u]),
                                  std::fmin(position[axes.v] - r.v0, r.v1 - position[axes.v]));
  const double edge = shift + error * length(Vec3d(ray.direction));
  if (!(std::fabs(margin) > edge)) return {Verdict::borderline, t, error};  // also along the plane
  return margin < 0 ? ExactHit{Verdict::miss, t, error} : judge(ray, t, error);
}

// By the plane and then the three sides; near a side single precision may say either.
ExactHit exact_triangle(const Ray& ray, const SceneView& scene, const Triangle& triangle) {
  Vec3d p[3];
  double size = max_abs_component(Vec3d(ray.origin));
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = Vec3d(scene.vertices.positions[triangle.vertices[i]]);
    size = std::fmax(size, max_abs_component(p[i]));
  }
  const Vec3d direction(ray.direction), normal = cross(p[1] - p[0], p[2] - p[0]);
  const double area = length(normal), slope = std::fabs(dot(direction, normal));
  const double t = dot(p[0] - Vec3d(ray.origin), normal) / dot(direction, normal);
  const double shift = kUnits * size;
  const double error = shift * area / slope;
  if (!(slope > 0) || !std::isfinite(error)) return {Verdict::borderline, t, error};
  const Vec3d at = Vec3d(ray.origin) + t * direction;
  double margin = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3d side = p[(i + 1) % 3] - p[i];
    margin = std::fmin(margin, dot(cross(side, at - p[i]), normal) / (length(side) * area));
  }
  if (!(std::fabs(margin) > shift + error * length(direction))) {
    return {Verdict::borderline, t, error};
  }
  return margin < 0 ? ExactHit{Verdict::miss, t, error} : judge(ray, t, error);
}

}  // namespace

ExactHit exact_hit(const SceneView& scene, const Ray& ray, PrimId prim) {
  const ShapeRef shape = shape_of(scene, prim);
  if (shape.kind == ShapeKind::sphere) return exact_sphere(ray, scene.spheres[shape.index]);
  if (shape.kind == ShapeKind::triangle) {
    return exact_triangle(ray, scene, scene.triangles[shape.index]);
  }
  return exact_rectangle(ray, rectangle_axes(shape.kind),
                         scene.rectangles[rectangle_index(shape.kind)][shape.index]);
}

}  // namespace dapple::bench
