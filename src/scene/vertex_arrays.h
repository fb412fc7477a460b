// Joining vertices of which some lack an attribute that others have.
#pragma once

#include "scene/mesh.h"

namespace dapple {

// An attribute that only one side has gets the value that stands for none on the other: zero for
// normals, tangents and uvs, white for colours.
void append_vertices(const Vertices& from, Vertices& to);

}  // namespace dapple
