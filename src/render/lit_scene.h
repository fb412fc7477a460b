// What the light transport of models reads besides the acceleration structure.
#pragma once

#include "render/surface_builder.h"
#include "scene/scene_view.h"
#include "shading/light_set.h"
#include "shading/material_evaluator.h"
#include "shading/texture_set.h"

namespace dapple {

// True for scenes of the classic kind: no layered material, and the blue sky around them.
[[nodiscard]] bool is_classic(const SceneView& scene);

// The members refer to each other, so this stays where it was made. The arrays behind the view must
// outlive it.
class LitScene {
 public:
  explicit LitScene(const SceneView& scene);
  LitScene(const LitScene&) = delete;
  LitScene& operator=(const LitScene&) = delete;

  const MaterialEvaluator& materials() const { return materials_; }
  const LightSet& lights() const { return lights_; }
  const SurfaceBuilder& surfaces() const { return surfaces_; }
  // Some material lets light pass through without scattering it.
  bool has_transparency() const { return has_transparency_; }

 private:
  TextureSet textures_;
  MaterialEvaluator materials_;
  LightSet lights_;
  SurfaceBuilder surfaces_;
  bool has_transparency_ = false;
};

}  // namespace dapple
