// Standard output whose failures are noticed: a full disk or a closed pipe is an error.
#pragma once

#include <string_view>

#include "util/error.h"

namespace dapple {

// Writes and flushes.
[[nodiscard]] Status print_output(std::string_view text);

}  // namespace dapple
