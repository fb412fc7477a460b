#include "render/prepared_scene.h"

#include <utility>

namespace dapple {

PreparedScene::PreparedScene(const SceneView& scene, std::unique_ptr<Accel> accel)
    : scene_(scene),
      first_ids_(first_prim_ids(scene)),
      accel_(std::move(accel)),
      materials_(material_records(scene.materials)),
      lit_(is_classic(scene) ? nullptr : std::make_unique<LitScene>(scene)) {}

SurfaceView PreparedScene::surfaces() const {
  SurfaceView view;
  view.leaves = accel_->leaves();
  view.instances = accel_->instances();
  view.materials = materials_.data();
  view.material_count = materials_.size();
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    view.materials_of[k] = scene_.materials_of(static_cast<ShapeKind>(k)).data();
    view.first_ids[k] = static_cast<PrimId>(first_ids_[k]);
  }
  return view;
}

const Material& PreparedScene::material_of(const Hit& hit) const {
  const ShapeKind kind = hit.lane.kind();
  const std::size_t index = hit.prim - first_ids_[static_cast<std::size_t>(kind)];
  return scene_.materials[index_of(scene_.materials_of(kind)[index])];
}

}  // namespace dapple
