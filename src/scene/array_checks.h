// What must hold of each element of a scene's arrays, checked in pieces and in any order.
#pragma once

#include <string>

#include "scene/scene_arrays.h"

namespace dapple {

// What indices must be below. The numbers of materials and textures are given, not taken from a
// view, so that a file can be checked before its materials are decoded.
struct ArrayLimits {
  std::size_t materials = 0;
  std::size_t layered_materials = 0;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t prototypes = 0;
  std::size_t textures = 0;
  std::size_t images = 0;
  std::size_t texel_bytes = 0;

  ArrayLimits(const SceneView& scene, std::size_t material_count);
};

// The first element of [begin, end) of an array that must not be, or `end`. Reads those elements
// and, of prototypes and images, the one before and whether one follows.
[[nodiscard]] std::size_t first_invalid(const SceneView& scene, const ArrayLimits& limits,
                                        SceneArray array, std::size_t begin, std::size_t end);

// What is wrong with such an element.
[[nodiscard]] std::string why_invalid(const SceneView& scene, const ArrayLimits& limits,
                                      SceneArray array, std::size_t index);

}  // namespace dapple
