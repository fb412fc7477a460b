// From the stored mesh to where its vertices stand: morph targets, skins, node transforms.
#pragma once

#include <span>
#include <vector>

#include "import/gltf/primitive.h"
#include "math/transform.h"

namespace dapple::gltf {

// The vertices with every target added as much as its weight says; missing weights are zero.
[[nodiscard]] Vertices morphed(const Primitive& primitive, std::span<const double> weights);

// Moves each vertex by the weighted mean of its joints' transforms. False if a joint does not
// exist.
[[nodiscard]] bool skin(const Influences& influences, std::span<const Transformd> joints,
                        Vertices& vertices);

// Moves all vertices. A transform that mirrors keeps normals outside; the triangles' winding is
// then for the caller to turn.
void place(const Transformd& to_world, Vertices& vertices);

}  // namespace dapple::gltf
