// Materials of a scene that assimp has read.
#pragma once

#include <assimp/scene.h>

#include <vector>

#include "import/model_import.h"

namespace dapple::assimp {

// One for each of the scene's, in order.
[[nodiscard]] Expected<std::vector<MaterialId>> add_materials(const aiScene& scene,
                                                              ModelImport& import);

}  // namespace dapple::assimp
