#include "scene_file/scene_source.h"

#include <utility>

#include "scene/named_scenes.h"

namespace dapple {

SceneSource::SceneSource(Scene scene)
    : scene_(std::make_unique<Scene>(std::move(scene))), view_(*scene_) {}

Expected<SceneSource> SceneSource::open(const std::string& name_or_path) {
  auto scene = make_named_scene(name_or_path);
  if (!scene) return tl::unexpected(scene.error());
  return SceneSource(std::move(*scene));
}

}  // namespace dapple
