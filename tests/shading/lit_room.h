// A scene of lights alone, with what reads it.
#pragma once

#include "scene/scene.h"
#include "shading/light_set.h"

namespace dapple::test {

class LitRoom {
 public:
  LitRoom() { scene.environment.kind = EnvironmentKind::none; }

  MaterialId add_glow(const Vec3f& radiance) {
    scene.layered_materials.emplace_back().emission = radiance;
    const auto index = static_cast<std::uint32_t>(scene.layered_materials.size() - 1);
    return scene.add_material(Layered{index});
  }
  void add_triangle(const Vec3f& a, const Vec3f& b, const Vec3f& c, MaterialId material) {
    const auto first = static_cast<std::uint32_t>(scene.vertices.positions.size());
    for (const Vec3f& p : {a, b, c}) scene.vertices.positions.push_back(p);
    scene.triangles.push_back({{first, first + 1, first + 2}});
    scene.triangle_materials.push_back(material);
  }

  Scene scene;
};

// What reads a scene that does not change any more.
struct LitView {
  explicit LitView(const Scene& scene)
      : view(scene), textures(view), materials(view, textures), lights(view, textures, materials) {}

  SceneView view;
  TextureSet textures;
  MaterialEvaluator materials;
  LightSet lights;
};

}  // namespace dapple::test
