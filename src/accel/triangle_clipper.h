// Boxes of parts of triangles, for trees that hold a triangle in several leaves.
#pragma once

#include <span>

#include "accel/build_prim.h"

namespace dapple {

class TriangleClipper {
 public:
  // For primitives of the scene, which must outlive this; `box` is around all of their tree.
  TriangleClipper(const SceneView& scene, const Bounds3f& box);

  bool can_split(const BuildPrim& prim) const { return prim.id - first_id_ < count_; }

  // The boxes of the parts of a triangle between planes that ascend, from the lower end of the
  // primitive's box to its upper end: parts[i] is between planes i and i + 1, and lo > hi where
  // nothing is there. Parts of a part stay inside its box; those of a whole triangle may reach
  // beyond it by the same little as everywhere.
  void clip(const BuildPrim& prim, int axis, std::span<const float> planes, Box4* parts) const;

 private:
  const SceneView& scene_;
  PrimId first_id_, count_;
  Float4 pad_;
};

}  // namespace dapple
