// Meshes, lights and cameras of a scene that assimp has read, where its nodes put them.
#pragma once

#include <assimp/scene.h>

#include <vector>

#include "import/model_import.h"

namespace dapple::assimp {

// `materials` are those of the scene, in order. A mesh that several nodes show is stored once.
[[nodiscard]] Status add_nodes(const aiScene& scene, const std::vector<MaterialId>& materials,
                               ModelImport& import);

}  // namespace dapple::assimp
