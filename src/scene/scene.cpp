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

void Scene::add_triangle(const Triangle& triangle, MaterialId material) {
  triangles.push_back(triangle);
  triangle_materials.push_back(material);
  count_object(ShapeKind::triangle);
}

void Scene::add_cylinder(const Cylinder& cylinder, MaterialId material) {
  cylinders.push_back(cylinder);
  cylinder_materials.push_back(material);
  count_object(ShapeKind::cylinder);
}

std::uint32_t Scene::add_prototype(std::span<const Triangle> of, std::span<const MaterialId> ids) {
  prototypes.push_back(
      {static_cast<std::uint32_t>(triangles.size()), static_cast<std::uint32_t>(of.size())});
  triangles.insert(triangles.end(), of.begin(), of.end());
  triangle_materials.insert(triangle_materials.end(), ids.begin(), ids.end());
  return static_cast<std::uint32_t>(prototypes.size() - 1);
}

void Scene::add_instance(const Instance& instance) {
  instances.push_back(instance);
  count_object(ShapeKind::instance);
}

void Scene::count_object(ShapeKind kind) {
  if (runs.empty() || runs.back().kind != kind) runs.push_back({kind, 0});
  ++runs.back().count;
}

}  // namespace dapple
