// Polygons cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec3.h"

namespace dapple {

// A polygon with more corners than this is cut as a fan, whatever its shape: cutting a concave one
// takes time that grows with the cube of its corners.
inline constexpr std::size_t kMaxConcaveCorners = 1024;

using Corners = std::array<std::uint32_t, 3>;  // positions in the polygon

// Appends corner_count - 2 triangles in the polygon's own sense of turning. Concave polygons are
// cut by their ears; what cannot be cut so (it crosses itself) becomes a fan.
void triangulate(std::span<const Vec3f> polygon, std::vector<Corners>& triangles);

}  // namespace dapple
