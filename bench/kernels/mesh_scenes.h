// Scenes of triangles, generated: what meshes look like to a BVH.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "util/error.h"

namespace dapple::bench {

// bumps:N     a displaced sphere of about N triangles, as scanned statues are
// city:N      houses of about N long thin triangles in all directions
// soup:N      N triangles of many sizes that touch nothing
// interior:N  a room with columns, walls of large triangles and furniture of small ones
// Nothing when the name is none of these.
[[nodiscard]] Expected<std::optional<Scene>> make_mesh_scene(const std::string& name);

}  // namespace dapple::bench
