#include "kernels/surface.h"

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
  const Point at =
      shape.kind == ShapeKind::sphere
          ? on_sphere(scene.spheres[shape.index], near_surface)
          : on_rectangle(rectangle_axes(shape.kind),
                         scene.rectangles[rectangle_index(shape.kind)][shape.index], near_surface);
  const Vec3f normal = dot(ray.direction, at.outward) < 0.0f ? at.outward : -at.outward;
  return {at.position + at.error * normal, normal};
}

Bounds3f scene_bounds(const SceneView& scene) {
  Bounds3f box;
  for (const Sphere& sphere : scene.spheres) box.extend(sphere_bounds(sphere));
  for (std::size_t k = 0; k < kRectangleKindCount; ++k) {
    for (const Rectangle& rectangle : scene.rectangles[k]) {
      box.extend(rectangle_bounds(rectangle_kind(k), rectangle));
    }
  }
  return box;
}

}  // namespace dapple::bench
