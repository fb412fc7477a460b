// The reason of the last failure on each thread, kept without allocating.
#pragma once

#include <string_view>

namespace dapple {

// Cut to what there is room for.
void set_last_error(std::string_view text) noexcept;
[[nodiscard]] const char* last_error() noexcept;

}  // namespace dapple
