// Where the sections of a scene file lie.
#pragma once

#include <string>

#include "util/error.h"

namespace dapple::bench {

// layout.csv, of the file that storing `nice` gives.
[[nodiscard]] Status study_layout(const std::string& folder);

}  // namespace dapple::bench
