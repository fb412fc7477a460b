// Where a path meets a surface.
#pragma once

#include <array>

#include "math/vec2.h"
#include "math/vec3.h"
#include "math/vec4.h"
#include "scene/mesh.h"

namespace dapple {

// World space throughout. The two normals and the tangent are unit vectors.
struct SurfaceInteraction {
  Vec3f position;
  Vec3f geometric_normal{0, 0, 1};  // outward: the side from which triangles are counter-clockwise
  Vec3f shading_normal{0, 0, 1};    // on the outward side too, up to 90 degrees off
  Vec3f tangent{1, 0, 0};           // orthogonal to shading_normal, along growing u
  float bitangent_sign = 1;         // the bitangent is sign * cross(shading_normal, tangent)
  std::array<Vec2f, kUvSetCount> uvs{};
  Vec4f colour{1, 1, 1, 1};  // of the vertices, linear
  // Lengths in texture space for one of world space: the square root of the areas' ratio.
  std::array<float, kUvSetCount> uv_per_length{};
  float cone_width = 0;      // of the ray cone where it meets the surface
  bool from_outside = true;  // the ray came from the side geometric_normal points to
};

}  // namespace dapple
