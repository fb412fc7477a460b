// Cameras and KHR_lights_punctual.
#pragma once

#include <vector>

#include "import/gltf/nodes.h"

namespace dapple::gltf {

[[nodiscard]] Status add_cameras(const Context& context, const std::vector<PlacedNode>& nodes);

// A scene with lamps of its own is lit by them alone, any other by the studio.
[[nodiscard]] Status add_lights(const Context& context, const std::vector<PlacedNode>& nodes);

}  // namespace dapple::gltf
