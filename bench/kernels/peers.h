// Which contenders this build has.
#pragma once

#include <string>

#include "kernels/kernel_bench.h"
#include "util/error.h"

namespace dapple::bench {

// `only` names the one contender to measure, or is empty for all; `quality` is low, medium or high
// and is Embree's build quality; `compact` asks both for the form of a tree that takes less memory.
[[nodiscard]] Expected<Contenders> make_contenders(const std::string& accel,
                                                   const std::string& only,
                                                   const std::string& quality, bool compact);

}  // namespace dapple::bench
