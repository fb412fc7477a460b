#include "scene/scene.h"

namespace dapple {

MaterialId Scene::add_material(const Material& material) {
  materials.push_back(material);
  return static_cast<MaterialId>(materials.size() - 1);
}

void Scene::add_sphere(const Sphere& sphere, MaterialId material) {
  spheres.push_back(sphere);
  sphere_materials.push_back(material);
  count_object(ShapeKind::sphere);
}

void Scene::add_rectangle(ShapeKind kind, const Rectangle& rectangle, MaterialId material) {
  rectangles[rectangle_index(kind)].push_back(rectangle);
  rectangle_materials[rectangle_index(kind)].push_back(material);
  count_object(kind);
}

void Scene::count_object(ShapeKind kind) {
  if (runs.empty() || runs.back().kind != kind) runs.push_back({kind, 0});
  ++runs.back().count;
}

}  // namespace dapple
