#include <algorithm>

#include "accel/wide_builder.h"
#include "parallel/parallel.h"
#include "scene/prims.h"

namespace dapple {
namespace {

void set_box(WideNode& node, std::size_t i, const Bounds3f& box) {
  for (int axis = 0; axis < 3; ++axis) {
    node.lo[axis][i] = box.lo[axis];
    node.hi[axis][i] = box.hi[axis];
  }
}

Bounds3f box_around(const WideNode& node) {
  Bounds3f box;
  for (std::size_t i = 0; i < kWideWidth; ++i) {
    box.extend({{node.lo[0][i], node.lo[1][i], node.lo[2][i]},
                {node.hi[0][i], node.hi[1][i], node.hi[2][i]}});
  }
  return box;
}

class Refitter {
 public:
  Refitter(const SceneView& scene, WideBvh& bvh)
      : scene_(scene),
        bvh_(bvh),
        prototypes_(prototype_boxes(scene)),
        first_ids_(first_prim_ids(scene)) {}

  void refit_leaves(WideNode& node) {
    for (std::size_t i = 0; i < kWideWidth; ++i) {
      if (node.children[i].is_leaf()) set_box(node, i, refit_leaf(node.children[i].leaf_ref()));
    }
  }

  // Children stand after their parents: from the end, they are ready when they are asked for.
  void refit_nodes() {
    for (std::size_t n = bvh_.nodes.size(); n-- > 0;) {
      WideNode& node = bvh_.nodes[n];
      for (std::size_t i = 0; i < kWideWidth; ++i) {
        const ChildRef child = node.children[i];
        if (child.is_node()) set_box(node, i, box_around(bvh_.nodes[child.node_index()]));
      }
    }
  }

 private:
  Bounds3f refit_leaf(LeafRef leaf) {
    const ShapeKind kind = leaf.kind();
    LeafRow* rows = bvh_.rows.data() + leaf.first_row();
    const LeafRow ids = rows[leaf_id_row(kind, bvh_.form)];
    Bounds3f box;
    for (std::size_t lane = 0; lane < kLeafWidth && ids.words[lane] != kNoPrim; ++lane) {
      const PrimId id = ids.words[lane];
      const std::size_t index = id - first_ids_[static_cast<std::size_t>(kind)];
      write_lane(scene_, prototypes_, kind, index, id, rows, lane, bvh_.form);
      box.extend(shape_bounds(scene_, prototypes_, kind, index));
    }
    return box;
  }

  const SceneView& scene_;
  WideBvh& bvh_;
  PrototypeBoxes prototypes_;
  std::array<std::size_t, kShapeKindCount> first_ids_;
};

}  // namespace

void refit_wide_bvh(const SceneView& scene, WideBvh& bvh) {
  constexpr std::size_t kNodesAtOnce = 256;
  Refitter refitter(scene, bvh);
  const std::size_t count = bvh.nodes.size();
  parallel_for_dynamic((count + kNodesAtOnce - 1) / kNodesAtOnce, [&](std::size_t part) {
    const std::size_t end = std::min(count, (part + 1) * kNodesAtOnce);
    for (std::size_t n = part * kNodesAtOnce; n < end; ++n) refitter.refit_leaves(bvh.nodes[n]);
  });
  refitter.refit_nodes();
}

}  // namespace dapple
