// A study as a table for people.
#pragma once

#include <string>

#include "dapple/scaling/result.h"

namespace dapple::scaling {

[[nodiscard]] std::string to_text(const Result& result);

}  // namespace dapple::scaling
