// Meshes of a scene that assimp has read.
#pragma once

#include <assimp/mesh.h>

#include "import/scene_builder.h"
#include "math/transform.h"

namespace dapple::assimp {

// The triangles, in their own space.
[[nodiscard]] MeshData mesh_of(const aiMesh& mesh, MaterialId material);

// `to_world` must have an inverse. Outside stays outside where it mirrors.
void move(const Transformd& to_world, MeshData& mesh);

void add_points_and_lines(const aiMesh& mesh, const Transformd& to_world, MaterialId material,
                          SceneBuilder& builder);

}  // namespace dapple::assimp
