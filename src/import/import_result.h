// What comes out of an import.
#pragma once

#include <string>
#include <vector>

#include "scene/picture_shape.h"
#include "scene/scene.h"

namespace dapple {

struct ImportResult {
  Scene scene;
  std::vector<std::string> warnings;  // a line each, with their place
  PictureShape pictures = {};
};

}  // namespace dapple
