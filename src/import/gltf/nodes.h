// The tree of nodes: where each one stands.
#pragma once

#include <cstdint>
#include <vector>

#include "import/gltf/context.h"
#include "math/transform.h"

namespace dapple::gltf {

// Translation, rotation (a quaternion x y z w) and scale, or a matrix instead.
struct NodePose {
  Vec3d translation;
  double rotation[4] = {0, 0, 0, 1};
  Vec3d scale{1, 1, 1};
  std::vector<double> weights;  // of morph targets; empty: those of the mesh
};

// All poses of the file, before animation.
[[nodiscard]] std::vector<NodePose> stored_poses(const Document& document);

[[nodiscard]] Transformd transform_of(const NodePose& pose);

struct PlacedNode {
  std::uint32_t index = 0;
  Transformd to_world;
};

// The nodes of the chosen scene that are to be seen, parents before children. Cycles, nodes with
// two parents and scenes that do not exist are errors.
[[nodiscard]] Expected<std::vector<PlacedNode>> place_nodes(const Context& context,
                                                            const std::vector<NodePose>& poses);

// Where every node of the file stands, in the chosen scene or not: what skins are bound to.
[[nodiscard]] Expected<std::vector<Transformd>> world_transforms(
    const Context& context, const std::vector<NodePose>& poses);

}  // namespace dapple::gltf
