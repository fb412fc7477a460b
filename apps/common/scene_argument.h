// How programs read an argument that names a scene.
#pragma once

#include <string>

namespace dapple {

// True when SceneSource would read a file for this text, and something of that name exists.
[[nodiscard]] bool is_scene_file(const std::string& text);

}  // namespace dapple
