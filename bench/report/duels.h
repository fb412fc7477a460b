// `ray` against `ray_bvh`: who is done first, and from how many rays on the tree pays.
#pragma once

#include <string>

#include "util/error.h"

namespace dapple::bench {

// duels.csv: for each workload what preparing and rendering cost with and without the tree, on one
// thread in processor time.
[[nodiscard]] Status study_duels(const std::string& folder);

}  // namespace dapple::bench
