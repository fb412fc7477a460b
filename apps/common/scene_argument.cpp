#include "common/scene_argument.h"

#include <fmt/format.h>

#include <filesystem>

#include "scene/named_scenes.h"

namespace dapple {

bool is_scene_file(const std::string& text) {
  std::error_code ignored;
  return !is_scene_name(text) && std::filesystem::exists(text, ignored);
}

std::string as_file_path(const std::string& path) {
  return is_scene_name(path) ? fmt::format("./{}", path) : path;
}

}  // namespace dapple
