// From an OBJ file's separate indices to vertices that triangles share.
#pragma once

#include "import/mesh_data.h"
#include "import/obj/geometry.h"

namespace dapple::obj {

// The faces, cut into triangles. A corner without a normal gets that of its smoothing group (the
// mean of the group's faces around its position, weighted by their area), or zero where smoothing
// is off. materials[i] is the index of Geometry::materials, or kNone.
[[nodiscard]] MeshData build_mesh(const Geometry& geometry);

}  // namespace dapple::obj
