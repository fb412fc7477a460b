// Scenes of all kinds of objects and materials, a function of a seed.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace dapple::test {

// Coordinates of every magnitude up to the largest allowed, denormal numbers and both zeros among
// them; materials shared by several objects, by one and by none.
[[nodiscard]] Scene random_scene(std::uint64_t seed, std::size_t object_count);

}  // namespace dapple::test
