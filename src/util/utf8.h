// Text that comes from files.
#pragma once

#include <string_view>

namespace dapple {

// True for well-formed UTF-8: no stray or missing bytes, nothing encoded longer than needed, no
// surrogates, nothing beyond U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace dapple
