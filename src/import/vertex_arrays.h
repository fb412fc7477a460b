// What vertices take while they are gathered.
#pragma once

#include <cstdint>

#include "scene/vertex_arrays.h"

namespace dapple {

// What a vertex with all attributes takes.
inline constexpr std::uint64_t kMaxVertexBytes =
    2 * sizeof(Vec3f) + 2 * sizeof(Vec4f) + kUvSetCount * sizeof(Vec2f);

}  // namespace dapple
