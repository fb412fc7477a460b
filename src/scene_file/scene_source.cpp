#include "scene_file/scene_source.h"

#include <filesystem>
#include <utility>

#include "scene/named_scenes.h"

namespace dapple {

SceneSource::SceneSource(Scene scene)
    : scene_(std::make_unique<Scene>(std::move(scene))), view_(*scene_) {}

SceneSource::SceneSource(MappedScene file)
    : file_(std::make_unique<MappedScene>(std::move(file))) {}

bool SceneSource::is_path(const std::string& name_or_path) { return !is_scene_name(name_or_path); }

Expected<SceneSource> SceneSource::open(const std::string& name_or_path,
                                        const VerifyOptions& options) {
  std::error_code unknown;
  const auto status = std::filesystem::symlink_status(name_or_path, unknown);
  if (!is_path(name_or_path) || status.type() == std::filesystem::file_type::not_found) {
    auto scene = make_named_scene(name_or_path);
    if (!scene) return tl::unexpected(scene.error());
    return SceneSource(std::move(*scene));
  }
  auto file = MappedScene::open(name_or_path, options);
  if (!file) return tl::unexpected(file.error());
  return SceneSource(std::move(*file));
}

}  // namespace dapple
