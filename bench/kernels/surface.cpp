#include "kernels/surface.h"

#include <cmath>

#include "scene/prims.h"

namespace dapple::bench {
namespace {

// As the renderer moves the origins of scattered rays: a few units in the last place.
constexpr float kRelativeError = 0x1p-21f;

struct Point {
  Vec3f position;  // on the shape
  Vec3f outward;
  float error;
};

Point on_sphere(const Sphere& sphere, const Vec3f& near_surface) {
  const Vec3f centre(sphere.centre);
  const float radius = std::fabs(static_cast<float>(sphere.radius));
  const Vec3f outward = normalize(near_surface - centre);
  return {centre + radius * outward, outward,
          kRelativeError * (max_abs_component(centre) + radius)};
}

Point on_rectangle(RectangleAxes axes, const Rectangle& rectangle, Vec3f position) {
  position[axes.k] = static_cast<float>(rectangle.k);
  Vec3f outward;
  outward[axes.k] = 1.0f;
  return {position, outward, kRelativeError * max_abs_component(position)};
}

Point on_triangle(const SceneView& scene, const Triangle& triangle, const Vec3f& near_surface) {
  const auto corner = [&](std::size_t i) {
    return Vec3d(scene.vertices.positions[triangle.vertices[i]]);
  };
  const Vec3d normal = cross(corner(1) - corner(0), corner(2) - corner(0));
  const double squared = dot(normal, normal);
  const double off = squared > 0 ? dot(Vec3d(near_surface) - corner(0), normal) / squared : 0;
  const Vec3f position(Vec3d(near_surface) - off * normal);
  const Vec3f outward(squared > 0 ? normal / std::sqrt(squared) : Vec3d(0, 1, 0));
  return {position, outward, 2 * kRelativeError * max_abs_component(position)};
}

Point point_on(const SceneView& scene, const ShapeRef& shape, const Vec3f& near_surface) {
  if (shape.kind == ShapeKind::sphere) return on_sphere(scene.spheres[shape.index], near_surface);
  if (shape.kind == ShapeKind::triangle) {
    return on_triangle(scene, scene.triangles[shape.index], near_surface);
  }
  return on_rectangle(rectangle_axes(shape.kind),
                      scene.rectangles[rectangle_index(shape.kind)][shape.index], near_surface);
}

}  // namespace

ShapeRef shape_of(const SceneView& scene, PrimId prim) {
  ShapeRef shape{ShapeKind::sphere, prim};
  while (shape.index >= scene.count(shape.kind)) {
    shape.index -= scene.count(shape.kind);
    shape.kind = static_cast<ShapeKind>(static_cast<std::uint32_t>(shape.kind) + 1);
  }
  return shape;
}

Surface surface_at(const SceneView& scene, const Ray& ray, const Found& found) {
  const ShapeRef shape = shape_of(scene, found.prim);
  const Vec3f near_surface = ray.at(found.t);
  const Point at = point_on(scene, shape, near_surface);
  const Vec3f normal = dot(ray.direction, at.outward) < 0.0f ? at.outward : -at.outward;
  return {at.position + at.error * normal, normal};
}

Bounds3f scene_bounds(const SceneView& scene) { return dapple::scene_bounds(scene); }

}  // namespace dapple::bench
