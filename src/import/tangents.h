// Tangents for meshes without any, as normal maps expect them.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/mesh.h"

namespace dapple {

// The averaging of MikkTSpace, which editors bake normal maps with: corners of triangles that agree
// in position, normal and texture coordinates share a tangent, as long as the texture is not
// mirrored between them; each triangle counts by its angle there. It differs from the original in
// one respect: triangles that touch in a vertex, but are not joined by edges around it, share too.
// Vertices between mirrored halves are split. Missing normals become those of the triangles.
// Without texture coordinates nothing changes.
void make_tangents(std::uint32_t uv_set, Vertices& vertices, std::vector<Triangle>& triangles);

}  // namespace dapple
