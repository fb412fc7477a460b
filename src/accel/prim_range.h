// A run of primitives that becomes one subtree, with its boxes.
#pragma once

#include <cstddef>
#include <span>

#include "accel/build_prim.h"

namespace dapple {

struct PrimRange {
  std::size_t begin = 0, end = 0;
  Box4 box;              // of the primitives
  Box4 centre_box;       // of twice their centres
  std::size_t room = 0;  // free places behind the end

  std::size_t size() const { return end - begin; }
  void extend(const BuildPrim& prim) {
    box.extend(prim);
    centre_box.extend(prim.twice_centre());
  }
  // The boxes of `other` as well; begin and end stay.
  void extend_boxes(const PrimRange& other) {
    box.extend(other.box);
    centre_box.extend(other.centre_box);
  }
};

// Ranges above this many primitives are worked on by several threads. Results depend on it, so it
// is a constant and not a function of the number of threads.
inline constexpr std::size_t kParallelRange = std::size_t{1} << 16;
inline constexpr std::size_t kParallelGrain = std::size_t{1} << 14;

// The range [begin, end) with its boxes computed.
[[nodiscard]] PrimRange measure_range(std::span<const BuildPrim> prims, std::size_t begin,
                                      std::size_t end);

}  // namespace dapple
