// A photographer's studio, for scenes that bring no light of their own.
#pragma once

#include <vector>

#include "math/vec3.h"

namespace dapple {

inline constexpr int kStudioWidth = 512, kStudioHeight = 256;

// Neutral equirectangular radiance, top row first, y up: a dim room that is brighter above than
// below, with a large softbox in front on the left, a weaker one on the right, a strip behind and
// a panel overhead. "In front" is +z.
[[nodiscard]] std::vector<Vec3f> studio_pixels();

}  // namespace dapple
