// Which name did somebody who mistyped one mean?
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

// The name with the fewest insertions, deletions and replacements of a character, if they are few.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view typed,
                                                      const std::vector<std::string>& names);

}  // namespace dapple
