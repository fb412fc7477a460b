// What surfaces wear whose file says nothing about them.
#pragma once

#include "scene/layered_material.h"

namespace dapple {

// A light grey that glistens a little, seen from both sides.
[[nodiscard]] inline LayeredMaterial default_material() {
  LayeredMaterial material;
  material.base_colour = {0.8f, 0.8f, 0.8f};
  material.roughness = 0.5f;
  return material;
}

}  // namespace dapple
