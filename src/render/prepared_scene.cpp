#include "render/prepared_scene.h"

#include <utility>

namespace dapple {

PreparedScene::PreparedScene(const SceneView& scene, std::unique_ptr<Accel> accel)
    : scene_(scene), first_ids_(first_prim_ids(scene)), accel_(std::move(accel)) {}

const Material& PreparedScene::material_of(const Hit& hit) const {
  const ShapeKind kind = hit.lane.kind();
  const std::size_t index = hit.prim - first_ids_[static_cast<std::size_t>(kind)];
  return scene_.materials[index_of(scene_.materials_of(kind)[index])];
}

}  // namespace dapple
