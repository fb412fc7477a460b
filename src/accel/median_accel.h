// The textbook BVH that courses teach: binary, sorted by the minimum along an axis that changes
// from level to level, split at the median, one object a leaf. Single precision and scalar.
#pragma once

#include <vector>

#include "accel/accel.h"
#include "accel/build_prim.h"
#include "accel/leaf_list.h"
#include "accel/prepared_ray.h"

namespace dapple {

class MedianAccel final : public Accel {
 public:
  explicit MedianAccel(const SceneView& scene);

  using Accel::intersect;
  using Accel::occluded;
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const override;
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override;
  AccelStats stats() const override;
  Bounds3f bounds() const override;

 private:
  // The children are the next node and node `second`; a leaf, which holds one primitive, has none.
  struct Node {
    Bounds3f box;
    std::uint32_t second = 0;
    PrimId prim = kNoPrim;

    bool is_leaf() const { return prim != kNoPrim; }
  };

  void build(std::span<BuildPrim> prims, int axis, std::size_t node);
  void visit_instance(const PreparedRay& ray, LeafRef lane, Hit& best) const;
  bool instance_occludes(const PreparedRay& ray, LeafRef lane) const;
  void visit(const PreparedRay& ray, std::size_t node, Hit& best) const;
  bool occludes(const PreparedRay& ray, std::size_t node) const;

  // Depth first: a subtree of n primitives is 2n - 1 nodes. The trees of prototypes follow that
  // of the world.
  std::vector<Node> nodes_;
  LeafList list_;
  std::vector<PlacedInstance> instances_;
  PrimId first_instance_ = 0;
  std::size_t prim_count_ = 0;
  std::size_t leaf_count_ = 0;
};

}  // namespace dapple
