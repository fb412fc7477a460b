// Scenes of long thin triangles, whose boxes are mostly empty, and rays that look for the places
// where those are cut.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/ray.h"
#include "scene/scene.h"

namespace dapple::test {

enum class Slivers {
  needles,   // single, from tiny to as long as the whole
  beams,     // closed, in all directions
  coplanar,  // in few planes, overlapping and repeated
  sheet,     // a closed mesh, stretched along a diagonal
  distant,   // beams where coordinates have few digits left
};
inline constexpr std::size_t kSliversCount = 5;

[[nodiscard]] Scene sliver_scene(Slivers kind, std::size_t triangles, std::uint64_t seed);

// At vertices, edges and insides of triangles, some along them, some from very far.
[[nodiscard]] std::vector<Ray> sliver_rays(const Scene& scene, std::size_t count,
                                           std::uint64_t seed);

}  // namespace dapple::test
