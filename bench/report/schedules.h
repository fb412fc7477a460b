// What the rendering loop would be with a static schedule over rows, beside what it is.
#pragma once

#include <string>

#include "util/error.h"

namespace dapple::bench {

// schedules.csv: for each schedule how long each of two threads worked and idled; rows.csv: what
// each row of the picture costs; predicted.csv: the share of the threads' time that is work, for
// more threads than this machine has cores, computed from those costs.
[[nodiscard]] Status study_schedules(const std::string& folder);

}  // namespace dapple::bench
