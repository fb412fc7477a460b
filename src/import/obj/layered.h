// From what a material library says to a layered material.
#pragma once

#include "import/model_import.h"
#include "import/obj/mtl.h"

namespace dapple::obj {

// With the PBR extension its numbers are the material's own. Without, Phong's exponent becomes a
// roughness, `Ks` tints the reflection of a dielectric, illum 3 and 5 without `Kd` is a mirror of
// the colour `Ks`, and illum 6 and 7 is glass of the index `Ni`. `file` names the library.
[[nodiscard]] Expected<LayeredMaterial> to_layered(const MtlMaterial& material,
                                                   const std::string& file, ModelImport& import);

}  // namespace dapple::obj
