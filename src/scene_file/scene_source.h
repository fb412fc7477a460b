// Where a scene comes from: its name, or a scene file.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "scene/scene_view.h"
#include "scene_file/mapped_scene.h"
#include "util/error.h"

namespace dapple {

// Owns what its view points at.
class SceneSource {
 public:
  // A scene's name (see named_scenes.h) comes before a file of the same name; `./nice` is always
  // the file. What is neither is an error that lists the names. The options are for files.
  [[nodiscard]] static Expected<SceneSource> open(const std::string& name_or_path,
                                                  const VerifyOptions& options = {});

  // A scene that somebody else has made, already found valid.
  [[nodiscard]] static SceneSource of(Scene scene) { return SceneSource(std::move(scene)); }

  // True when open() would look for a file.
  [[nodiscard]] static bool is_path(const std::string& name_or_path);

  const SceneView& view() const { return file_ ? file_->view() : view_; }
  // What the file says; nothing for a scene that is none.
  PictureShape pictures() const { return file_ ? file_->pictures() : PictureShape(); }

 private:
  explicit SceneSource(Scene scene);
  explicit SceneSource(MappedScene file);

  std::unique_ptr<Scene> scene_;
  std::unique_ptr<MappedScene> file_;
  SceneView view_;  // of scene_
};

}  // namespace dapple
