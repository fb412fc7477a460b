// What a ray found.
#pragma once

#include <cstdint>
#include <limits>

#include "scene/leaf.h"
#include "scene/scene_view.h"

namespace dapple {

struct Hit {
  float t = std::numeric_limits<float>::infinity();  // in units of the ray's direction
  PrimId prim = kNoPrim;
  LeafRef lane;  // the one primitive that was hit, inside its leaf, and through which instance

  bool found() const { return prim != kNoPrim; }
  friend bool operator==(const Hit& a, const Hit& b) {
    return a.t == b.t && a.prim == b.prim && a.lane.seen_through() == b.lane.seen_through();
  }
};
static_assert(sizeof(Hit) == 16);

}  // namespace dapple
