// Where a scene comes from: its name, or a scene file.
#pragma once

#include <memory>
#include <string>

#include "scene/scene_view.h"
#include "util/error.h"

namespace dapple {

// Owns what its view points at.
class SceneSource {
 public:
  // A scene's name (see named_scenes.h) comes before a file of the same name; `./nice` is always
  // the file. What is neither is an error that lists the names.
  [[nodiscard]] static Expected<SceneSource> open(const std::string& name_or_path);

  const SceneView& view() const { return view_; }

 private:
  explicit SceneSource(Scene scene);

  std::unique_ptr<Scene> scene_;
  SceneView view_;
};

}  // namespace dapple
