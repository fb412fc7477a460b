// Normals of smoothing groups.
#pragma once

#include "import/obj/geometry.h"

namespace dapple::obj {

// Gives each corner of a smoothed face that has no normal one of its own group, appended to
// geometry.normals and shared by the group's corners at one position.
void add_smooth_normals(Geometry& geometry);

}  // namespace dapple::obj
