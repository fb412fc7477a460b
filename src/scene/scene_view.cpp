#include "scene/scene_view.h"

namespace dapple {

SceneView::SceneView(const Scene& scene)
    : camera(scene.camera),
      materials(scene.materials),
      runs(scene.runs),
      spheres(scene.spheres),
      sphere_materials(scene.sphere_materials) {
  for (std::size_t i = 0; i < kRectangleKindCount; ++i) {
    rectangles[i] = scene.rectangles[i];
    rectangle_materials[i] = scene.rectangle_materials[i];
  }
}

std::size_t SceneView::object_count() const {
  std::size_t total = spheres.size();
  for (const auto& of_kind : rectangles) total += of_kind.size();
  return total;
}

std::size_t SceneView::count(ShapeKind kind) const {
  return kind == ShapeKind::sphere ? spheres.size() : rectangles[rectangle_index(kind)].size();
}

std::span<const MaterialId> SceneView::materials_of(ShapeKind kind) const {
  return kind == ShapeKind::sphere ? sphere_materials : rectangle_materials[rectangle_index(kind)];
}

std::array<std::size_t, kShapeKindCount> first_prim_ids(const SceneView& scene) {
  std::array<std::size_t, kShapeKindCount> first{};
  for (std::size_t kind = 1; kind < kShapeKindCount; ++kind) {
    first[kind] = first[kind - 1] + scene.count(static_cast<ShapeKind>(kind - 1));
  }
  return first;
}

}  // namespace dapple
