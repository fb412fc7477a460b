// All arrays of a scene in one list, for code that does the same with each of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "scene/scene_view.h"

namespace dapple {

// Arrays of plain records: the same in memory and in a file. (Materials, which are variants, and
// runs are not among them.)
enum class SceneArray : std::uint32_t {
  spheres,
  sphere_materials,
  xy_rectangles,
  xy_rectangle_materials,
  xz_rectangles,
  xz_rectangle_materials,
  yz_rectangles,
  yz_rectangle_materials,
  positions,
  normals,
  tangents,
  uvs0,
  uvs1,
  colours,
  triangles,
  triangle_materials,
  cylinders,
  cylinder_materials,
  prototypes,
  instances,
  layered_materials,
  textures,
  images,
  texels,
  lights,
  cameras,
};
inline constexpr std::size_t kSceneArrayCount = 26;

// "vertex position": one element of the array, for errors.
[[nodiscard]] std::string_view element_name(SceneArray array);

// Calls visit(SceneArray, array...) for each array, with that of every scene given: Scenes, whose
// arrays are vectors, or SceneViews, whose arrays are spans, in any mixture.
template <class Visit, class... Scenes>
void for_each_array(Visit&& visit, Scenes&&... s) {
  static_assert(kRectangleKindCount == 3 && kUvSetCount == 2);
  visit(SceneArray::spheres, s.spheres...);
  visit(SceneArray::sphere_materials, s.sphere_materials...);
  visit(SceneArray::xy_rectangles, s.rectangles[0]...);
  visit(SceneArray::xy_rectangle_materials, s.rectangle_materials[0]...);
  visit(SceneArray::xz_rectangles, s.rectangles[1]...);
  visit(SceneArray::xz_rectangle_materials, s.rectangle_materials[1]...);
  visit(SceneArray::yz_rectangles, s.rectangles[2]...);
  visit(SceneArray::yz_rectangle_materials, s.rectangle_materials[2]...);
  visit(SceneArray::positions, s.vertices.positions...);
  visit(SceneArray::normals, s.vertices.normals...);
  visit(SceneArray::tangents, s.vertices.tangents...);
  visit(SceneArray::uvs0, s.vertices.uvs[0]...);
  visit(SceneArray::uvs1, s.vertices.uvs[1]...);
  visit(SceneArray::colours, s.vertices.colours...);
  visit(SceneArray::triangles, s.triangles...);
  visit(SceneArray::triangle_materials, s.triangle_materials...);
  visit(SceneArray::cylinders, s.cylinders...);
  visit(SceneArray::cylinder_materials, s.cylinder_materials...);
  visit(SceneArray::prototypes, s.prototypes...);
  visit(SceneArray::instances, s.instances...);
  visit(SceneArray::layered_materials, s.layered_materials...);
  visit(SceneArray::textures, s.textures...);
  visit(SceneArray::images, s.images...);
  visit(SceneArray::texels, s.texels...);
  visit(SceneArray::lights, s.lights...);
  visit(SceneArray::cameras, s.cameras...);
}

// A Scene with all that the view says, its BVH aside.
[[nodiscard]] Scene copy_of(const SceneView& view);

}  // namespace dapple
