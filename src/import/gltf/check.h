// Proves that a file is glTF before anything reads it. What makes the picture doubtful is an error;
// what breaks the specification, but leaves the picture as it was meant, is a warning.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "import/gltf/accessors.h"
#include "import/gltf/context.h"
#include "import/gltf/nodes.h"

namespace dapple::gltf {

// Kinds, ranges and references of every member; versions; extensions.
[[nodiscard]] Status check_structure(const Context& context);
// Buffer views, accessors, cameras, images.
[[nodiscard]] Status check_data(const Context& context);
// Attributes, indices and morph targets of primitives, and what their materials need.
[[nodiscard]] Status check_meshes(const Context& context);
// Nodes, skins, animations, lights.
[[nodiscard]] Status check_nodes(const Context& context);

// What the data says, once everything that `nodes` show is in the scene: what is wrong with the
// rest is a warning each. `images` are those that were read.
void check_contents(const Context& context, Buffers& buffers, Accessors& accessors,
                    const std::vector<PlacedNode>& nodes, const std::set<std::uint32_t>& images);

}  // namespace dapple::gltf
