// The description of `dapple scaling`.
#pragma once

#include "common/command_table.h"

namespace dapple {

[[nodiscard]] CommandInfo scaling_command();

}  // namespace dapple
