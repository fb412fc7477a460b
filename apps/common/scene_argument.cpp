#include "common/scene_argument.h"

#include <filesystem>

#include "scene_file/scene_source.h"

namespace dapple {

bool is_scene_file(const std::string& text) {
  std::error_code ignored;
  return SceneSource::is_path(text) && std::filesystem::exists(text, ignored);
}

}  // namespace dapple
