// What --help prints.
#pragma once

#include <string>

#include "common/command_table.h"

namespace dapple {

// Lines are at most 80 columns wide where words allow it.
[[nodiscard]] std::string help_page(const CommandInfo& command);

// `text` in lines of at most `width` columns, every line but the first indented by `indent`.
[[nodiscard]] std::string wrap(std::string_view text, std::size_t width, std::size_t indent);

}  // namespace dapple
