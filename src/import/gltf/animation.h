// Animations at one moment.
#pragma once

#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/nodes.h"

namespace dapple::gltf {

// Changes the poses to those at `time` seconds; before its first and after its last key an
// animation stands still. All animations of the file play together; where two want the same
// property of a node, the first one has it.
[[nodiscard]] Status animate(const Context& context, Accessors& accessors, double time,
                             std::vector<NodePose>& poses);

}  // namespace dapple::gltf
