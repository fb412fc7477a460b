// Points and lines that a file has in place of surfaces, as small spheres and thin cylinders.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "import/scene_builder.h"

namespace dapple {

// Half the mean distance of `count` points spread evenly over a surface of the extent of
// `positions`; never 0.
[[nodiscard]] double default_point_radius(std::span<const Vec3f> positions, std::size_t count);

struct PointCloud {
  std::span<const Vec3f> positions;
  std::span<const Vec4f> colours;  // linear; empty: all are white
  std::span<const float> radii;    // empty: all have `radius`
  double radius = 0;
};

// Colours are rounded to the nearest of 8 bits a channel. The result is the number of points left
// out because their position or radius is not finite or too large.
[[nodiscard]] Expected<std::size_t> add_points(const PointCloud& cloud, SceneBuilder& builder);

}  // namespace dapple
