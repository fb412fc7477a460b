// The door to every kind of scene: named ones, scene files and files that can be imported.
#pragma once

#include <string>
#include <vector>

#include "import/import_options.h"
#include "scene/picture_shape.h"
#include "scene_file/scene_source.h"
#include "util/error.h"

namespace dapple {

struct SceneInput {
  SceneSource source;
  bool has_camera = true;             // false: the file had none, and one was made that sees it all
  std::vector<std::string> warnings;  // a line each
  PictureShape pictures = {};
  bool imported = false;  // from a model file: the options of imports had their say

  const SceneView& view() const { return source.view(); }
};

// The options are for scene files and for imports. A name comes before a file of the same name; a
// file whose ending belongs to an importer is imported, any other is a scene file or, by its first
// bytes, something that can be imported.
[[nodiscard]] Expected<SceneInput> open_scene_input(const std::string& name_or_path,
                                                    const VerifyOptions& verify = {},
                                                    const ImportOptions& import = {});

}  // namespace dapple
