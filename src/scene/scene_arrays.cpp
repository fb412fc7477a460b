#include "scene/scene_arrays.h"

#include <array>

namespace dapple {

std::string_view element_name(SceneArray array) {
  constexpr std::array<std::string_view, kSceneArrayCount> kNames = {
      "sphere",
      "material of sphere",
      "xy_rectangle",
      "material of xy_rectangle",
      "xz_rectangle",
      "material of xz_rectangle",
      "yz_rectangle",
      "material of yz_rectangle",
      "vertex position",
      "vertex normal",
      "vertex tangent",
      "vertex uv",
      "second vertex uv",
      "vertex colour",
      "triangle",
      "material of triangle",
      "cylinder",
      "material of cylinder",
      "prototype",
      "instance",
      "layered material",
      "texture",
      "image",
      "texel byte",
      "light",
      "camera",
  };
  return kNames[static_cast<std::size_t>(array)];
}

Scene copy_of(const SceneView& view) {
  Scene scene;
  scene.camera = view.camera;
  scene.materials.assign(view.materials.begin(), view.materials.end());
  scene.runs.assign(view.runs.begin(), view.runs.end());
  for_each_array(
      [](SceneArray, const auto& from, auto& to) { to.assign(from.begin(), from.end()); }, view,
      scene);
  scene.environment = view.environment;
  return scene;
}

}  // namespace dapple
