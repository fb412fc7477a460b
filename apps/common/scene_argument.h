// How programs read an argument that names a scene.
#pragma once

#include <string>

#include "scene_file/scene_source.h"

namespace dapple {

// True when SceneSource would read a file for this text, and something of that name exists.
[[nodiscard]] bool is_scene_file(const std::string& text);

// The same file written so that it cannot be taken for a scene's name.
[[nodiscard]] std::string as_file_path(const std::string& path);

}  // namespace dapple
