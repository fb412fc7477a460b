// Numbers from command lines: the whole text must be the number, nothing is guessed.
#pragma once

#include <cstdint>
#include <string_view>

#include "util/error.h"

namespace dapple {

// A decimal integer in [low, high]. "12x", "", "+3", "1e9" and " 7" are errors; `name` is what
// the error says the text should have been.
[[nodiscard]] Expected<std::int64_t> parse_integer(std::string_view text, std::string_view name,
                                                   std::int64_t low, std::int64_t high);

}  // namespace dapple
