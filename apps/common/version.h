// What --version prints.
#pragma once

#include <string>
#include <string_view>

namespace dapple {

// "PROGRAM VERSION" and how this program was built.
[[nodiscard]] std::string version_text(std::string_view program);

}  // namespace dapple
