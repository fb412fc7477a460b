// A binary tree made better: subtrees are taken out and put back where they cost least
// [BittnerHH13].
#pragma once

#include <cstdint>
#include <vector>

#include "accel/build_prim.h"

namespace dapple {

struct TreeShapeNode {
  Box4 box;
  std::uint32_t left = 0, right = 0;  // 0 for a leaf: node 0 is the root
};
using TreeShape = std::vector<TreeShapeNode>;

// False, and then the tree is not to be used, if it got more levels below the root than
// `max_depth`.
[[nodiscard]] bool reinsert_subtrees(TreeShape& tree, int max_depth);

}  // namespace dapple
