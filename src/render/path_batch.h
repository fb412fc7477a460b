// Memory for paths in flight, used again from one batch to the next.
#pragma once

#include <cstdint>

#include "render/kernels/path_kernels.h"
#include "util/huge_array.h"

namespace dapple {

class PathBatch {
 public:
  // Room for `capacity` paths; what was there may be lost.
  void reserve(std::size_t capacity);

  PathArrays& arrays() { return arrays_; }

 private:
  HugeArray<std::uint8_t> memory_;
  std::size_t capacity_ = 0;
  PathArrays arrays_{};
};

}  // namespace dapple
