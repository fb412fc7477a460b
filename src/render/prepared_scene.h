// What integrators see: an acceleration structure, the camera and the materials of primitives.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "accel/accel.h"
#include "render/kernels/path_kernels.h"
#include "render/lit_scene.h"
#include "scene/scene_view.h"

namespace dapple {

// The arrays behind the view must outlive this.
class PreparedScene {
 public:
  PreparedScene(const SceneView& scene, std::unique_ptr<Accel> accel);

  const Camera& camera() const { return scene_.camera; }
  const Accel& accel() const { return *accel_; }
  const Material& material_of(const Hit& hit) const;
  // Null for a classic scene.
  const LitScene* lit_or_null() const { return lit_.get(); }
  const LitScene& lit() const { return *lit_; }
  // For the kernels; valid as long as this.
  SurfaceView surfaces() const;

 private:
  SceneView scene_;
  std::array<std::size_t, kShapeKindCount> first_ids_;
  std::unique_ptr<Accel> accel_;
  std::vector<PackedMaterial> materials_;
  std::unique_ptr<LitScene> lit_;
};

}  // namespace dapple
