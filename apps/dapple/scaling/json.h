// A study as JSON: base work, machine, warnings, curves with their fits, and every run.
#pragma once

#include <string>

#include "dapple/scaling/result.h"

namespace dapple::scaling {

[[nodiscard]] std::string to_json_text(const Result& result);

}  // namespace dapple::scaling
