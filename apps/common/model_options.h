// Options about models and how they are looked at.
#pragma once

#include <vector>

#include "common/command_table.h"

namespace dapple {

// What can be asked of an import.
[[nodiscard]] std::vector<OptionInfo> import_options();
// Camera and surroundings.
[[nodiscard]] std::vector<OptionInfo> view_options();
// How radiance becomes a picture.
[[nodiscard]] std::vector<OptionInfo> picture_options();

}  // namespace dapple
