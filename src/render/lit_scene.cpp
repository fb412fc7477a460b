#include "render/lit_scene.h"

namespace dapple {

bool is_classic(const SceneView& scene) {
  return scene.environment.kind == EnvironmentKind::classic_sky &&
         scene.layered_materials.empty() && scene.lights.empty() &&
         scene.camera.orthographic_height == 0;
}

LitScene::LitScene(const SceneView& scene)
    : textures_(scene),
      materials_(scene, textures_),
      lights_(scene, textures_, materials_),
      surfaces_(scene) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    has_transparency_ |= materials_.may_be_transparent(static_cast<MaterialId>(i));
  }
}

}  // namespace dapple
