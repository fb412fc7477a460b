// Which contenders this build has.
#pragma once

#include <string>

#include "kernels/kernel_bench.h"
#include "util/error.h"

namespace dapple::bench {

struct ContenderChoice {
  std::string accel = "fast";      // dapple's structure
  std::string only;                // the name of the one to measure, or empty for all
  std::string quality = "medium";  // of what dapple builds: low, medium or high
  std::string embree_quality = "medium";
  bool compact = false;  // both take the form of a tree that takes less memory
};

[[nodiscard]] Expected<Contenders> make_contenders(const ContenderChoice& choice);

}  // namespace dapple::bench
