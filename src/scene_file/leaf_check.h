// The inner loop of a BVH's proof: the primitives of one leaf against their box.
#pragma once

#include <span>

#include "math/bounds3.h"
#include "scene/leaf.h"

namespace dapple {

// The ids that the primitives of one kind have: `count` from `first` on.
struct IdRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

enum class LeafFault : int {
  none,
  empty,       // no primitives
  order,       // lanes in use do not come first, by ascending id
  unused,      // a lane that is not in use holds something
  id,          // not in the range of its kind
  coordinate,  // beyond kMaxCoordinate, or not finite
  box,         // a primitive's own box, as scene/prims.h computes it, is not inside the leaf's
};

struct LeafVerdict {
  LeafFault fault = LeafFault::none;
  std::size_t count = 0;  // of primitives, when there is no fault
};

// Reads leaf_rows(kind) rows from `leaf` on; the kind must be a known one.
using LeafCheck = LeafVerdict (*)(ShapeKind kind, const LeafRow* leaf, const Bounds3f& box,
                                  IdRange ids);

// The same function for each instruction set that this processor has, best first; never empty.
[[nodiscard]] std::span<const LeafCheck> leaf_checks();

}  // namespace dapple
