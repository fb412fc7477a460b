#include "scene/scene_view.h"

namespace dapple {

namespace {

VertexView view_of(const Vertices& vertices) {
  VertexView view{vertices.positions, vertices.normals, vertices.tangents, {}, vertices.colours};
  for (std::size_t i = 0; i < kUvSetCount; ++i) view.uvs[i] = vertices.uvs[i];
  return view;
}

}  // namespace

SceneView::SceneView(const Scene& scene)
    : camera(scene.camera),
      materials(scene.materials),
      runs(scene.runs),
      spheres(scene.spheres),
      sphere_materials(scene.sphere_materials),
      vertices(view_of(scene.vertices)),
      triangles(scene.triangles),
      triangle_materials(scene.triangle_materials),
      cylinders(scene.cylinders),
      cylinder_materials(scene.cylinder_materials),
      prototypes(scene.prototypes),
      instances(scene.instances),
      layered_materials(scene.layered_materials),
      textures(scene.textures),
      images(scene.images),
      texels(scene.texels),
      lights(scene.lights),
      environment(scene.environment),
      cameras(scene.cameras) {
  for (std::size_t i = 0; i < kRectangleKindCount; ++i) {
    rectangles[i] = scene.rectangles[i];
    rectangle_materials[i] = scene.rectangle_materials[i];
  }
}

std::size_t SceneView::object_count() const {
  std::size_t total = 0;
  for (std::size_t k = 0; k < kShapeKindCount; ++k)
    total += object_count(static_cast<ShapeKind>(k));
  return total;
}

std::size_t SceneView::object_count(ShapeKind kind) const {
  if (kind == ShapeKind::triangle && !prototypes.empty()) return prototypes[0].first_triangle;
  return count(kind);
}

std::size_t SceneView::count(ShapeKind kind) const {
  if (is_rectangle(kind)) return rectangles[rectangle_index(kind)].size();
  if (kind == ShapeKind::triangle) return triangles.size();
  if (kind == ShapeKind::cylinder) return cylinders.size();
  if (kind == ShapeKind::instance) return instances.size();
  return spheres.size();
}

std::span<const MaterialId> SceneView::materials_of(ShapeKind kind) const {
  if (is_rectangle(kind)) return rectangle_materials[rectangle_index(kind)];
  if (kind == ShapeKind::triangle) return triangle_materials;
  if (kind == ShapeKind::cylinder) return cylinder_materials;
  if (kind == ShapeKind::instance) return {};
  return sphere_materials;
}

std::size_t prim_count(const SceneView& scene) {
  std::size_t total = 0;
  for (std::size_t k = 0; k < kShapeKindCount; ++k) total += scene.count(static_cast<ShapeKind>(k));
  return total;
}

std::array<std::size_t, kShapeKindCount> first_prim_ids(const SceneView& scene) {
  std::array<std::size_t, kShapeKindCount> first{};
  for (std::size_t kind = 1; kind < kShapeKindCount; ++kind) {
    first[kind] = first[kind - 1] + scene.count(static_cast<ShapeKind>(kind - 1));
  }
  return first;
}

}  // namespace dapple
