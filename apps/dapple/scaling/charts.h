// The plots of a study.
#pragma once

#include <string>
#include <vector>

#include "dapple/scaling/result.h"

namespace dapple::scaling {

struct Chart {
  std::string file;  // its name
  std::string svg;
};

// Time, speed-up and efficiency for strong and for weak scaling, with the ideal line; and load
// imbalance.
[[nodiscard]] std::vector<Chart> make_charts(const Result& result);

}  // namespace dapple::scaling
