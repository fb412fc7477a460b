// Hits on triangles of the world whose surfaces are described many at once.
#pragma once

#include <cstdint>

#include "scene/leaf.h"
#include "scene/mesh.h"
#include "shading/bsdf_chunk.h"

namespace dapple {

// The arrays that a triangle's surface is read from; null: there are none.
struct MeshView {
  LeafArrays leaves;
  const std::uint32_t* corners = nullptr;    // three vertices a triangle
  const std::uint32_t* materials = nullptr;  // one a triangle
  const float* normals = nullptr;            // three a vertex
  const float* tangents = nullptr;           // four
  const float* uvs[kUvSetCount] = {};        // two
};

// A structure of arrays, like BsdfChunk.
struct alignas(64) SurfaceChunk {
  using Floats = float[kStride];
  using Vectors = float[3][kStride];

  Vectors origin = {}, direction = {};   // of the ray
  std::uint32_t lane[kStride] = {};      // lower half of the hit's LeafRef
  std::uint32_t triangle[kStride] = {};  // number in the scene's array

  // Of SurfacePoint and SurfaceInteraction.
  std::uint32_t material[kStride] = {};
  Vectors position = {}, outward = {}, shading_normal = {}, tangent = {};
  Floats error = {}, weight_1 = {}, weight_2 = {}, bitangent_sign = {};
  Floats u[kUvSetCount] = {}, v[kUvSetCount] = {}, uv_per_length[kUvSetCount] = {};
};

}  // namespace dapple
