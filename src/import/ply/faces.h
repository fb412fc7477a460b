// The elements "face" and "tristrips" of a PLY file.
#pragma once

#include "import/ply/model.h"
#include "import/ply/values.h"

namespace dapple::ply {

// Polygons are cut into triangles; those with fewer than three corners are counted.
[[nodiscard]] Status read_faces(ValueReader& values, const Element& element, Model& model);

// Strips of triangles that turn alternately; -1 begins a new one.
[[nodiscard]] Status read_strips(ValueReader& values, const Element& element, Model& model);

}  // namespace dapple::ply
