// One material object of glTF and its extensions.
#pragma once

#include <string>

#include "import/gltf/textures.h"

namespace dapple::gltf {

[[nodiscard]] Expected<LayeredMaterial> read_material(const JsonValue& json,
                                                      const std::string& pointer,
                                                      const Textures& textures);

}  // namespace dapple::gltf
