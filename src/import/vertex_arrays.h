// Joining vertices of which some lack an attribute that others have.
#pragma once

#include <cstdint>

#include "scene/mesh.h"

namespace dapple {

// What a vertex with all attributes takes.
inline constexpr std::uint64_t kMaxVertexBytes =
    2 * sizeof(Vec3f) + 2 * sizeof(Vec4f) + kUvSetCount * sizeof(Vec2f);

// An attribute that only one side has gets the value that stands for none on the other: zero for
// normals, tangents and uvs, white for colours.
void append_vertices(const Vertices& from, Vertices& to);

}  // namespace dapple
