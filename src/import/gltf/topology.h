// From the primitive modes of glTF to points, lines and triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "import/gltf/primitive.h"

namespace dapple::gltf {

enum Mode : std::uint32_t {
  kPoints = 0,
  kLines = 1,
  kLineLoop = 2,
  kLineStrip = 3,
  kTriangles = 4,
  kTriangleStrip = 5,
  kTriangleFan = 6,
};

// What is left over after the last whole line or triangle is ignored.
void assemble(const std::vector<std::uint32_t>& indices, std::uint32_t mode, Primitive& primitive);

}  // namespace dapple::gltf
