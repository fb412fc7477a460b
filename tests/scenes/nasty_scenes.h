// Random scenes and rays that look for trouble: degenerate, coincident, huge, tiny and distant
// objects; rays along axes, in the planes of boxes, from surfaces, with finite segments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/ray.h"
#include "scene/scene.h"

namespace dapple::test {

enum class Shapes { spheres, rectangles, mixture, triangles, everything, instances };
inline constexpr std::size_t kShapesCount = 6;

struct NastyConfig {
  Shapes shapes = Shapes::mixture;
  std::size_t object_count = 50;
  double size = 1;         // half the side of the cube in which objects lie
  double distance = 0;     // of that cube from the origin, along each axis
  bool on_grid = false;    // coordinates are multiples of an eighth of `size`: planes coincide
  double odd_share = 0.2;  // objects that are degenerate, repeated, huge or tiny
};

// A configuration for each seed; over many seeds all kinds of trouble occur.
[[nodiscard]] NastyConfig nasty_config(std::uint64_t seed);

[[nodiscard]] Scene nasty_scene(const NastyConfig& config, std::uint64_t seed);

// Rays that go with the scene.
[[nodiscard]] std::vector<Ray> nasty_rays(const Scene& scene, const NastyConfig& config,
                                          std::size_t count, std::uint64_t seed);

}  // namespace dapple::test
