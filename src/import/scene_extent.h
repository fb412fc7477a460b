// How large a scene is.
#pragma once

#include <limits>
#include <vector>

#include "scene/scene.h"

namespace dapple {

// A box in double precision; empty at first.
struct Extent {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3d low{kInfinity, kInfinity, kInfinity};
  Vec3d high{-kInfinity, -kInfinity, -kInfinity};

  void include(const Vec3d& point);
  // 0 when empty.
  double diagonal() const;
};

// Of all shapes, while the prototypes' triangles still lie apart. Instances count by the corners of
// their prototype's box.
[[nodiscard]] Extent extent_of(const Scene& scene,
                               const std::vector<Triangle>& prototype_triangles);

}  // namespace dapple
