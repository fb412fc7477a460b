// The element "vertex" of a PLY file.
#pragma once

#include "import/ply/model.h"
#include "import/ply/values.h"

namespace dapple::ply {

// Appends to model.mesh.vertices and model.radii; properties without a meaning go to model.ignored.
[[nodiscard]] Status read_vertices(ValueReader& values, const Element& element, Model& model);

}  // namespace dapple::ply
