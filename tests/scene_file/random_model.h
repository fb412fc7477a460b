// Scenes with everything that a scene can have, a function of a seed.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace dapple::test {

// Spheres and rectangles, and what the models of editors consist of: meshes with and without
// attributes, cylinders, prototypes and instances, layered materials, textures, lights, cameras.
// Every number may be any that is allowed; each kind of thing is missing in some scenes.
[[nodiscard]] Scene random_model(std::uint64_t seed);

// A wavy square of side x side pairs of triangles, with normals and texture coordinates.
[[nodiscard]] Scene large_mesh(std::uint32_t side);

}  // namespace dapple::test
