// What comes out of an import.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace dapple {

struct ImportResult {
  Scene scene;
  std::vector<std::string> warnings;  // a line each, with their place
  // Width and height that the file asks for.
  std::optional<std::array<int, 2>> resolution = std::nullopt;
  // Width over height that each of the scene's cameras is meant for; 0: any.
  std::vector<double> camera_aspects = {};
};

}  // namespace dapple
