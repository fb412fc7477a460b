// The tables of a study as comma-separated values, one header line each.
#pragma once

#include <string>

#include "dapple/scaling/result.h"

namespace dapple::scaling {

// A point of a curve a line; every figure has its confidence interval in NAME_low and NAME_high.
[[nodiscard]] std::string points_csv(const Result& result);
// A fitted law a line.
[[nodiscard]] std::string fits_csv(const Result& result);
// A thread of a run a line.
[[nodiscard]] std::string threads_csv(const Result& result);
// The machine and the warnings, KEY,VALUE.
[[nodiscard]] std::string machine_csv(const Result& result);

}  // namespace dapple::scaling
