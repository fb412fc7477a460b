// Options that several subcommands have.
#pragma once

#include "common/command_table.h"

namespace dapple {

[[nodiscard]] OptionInfo help_option();
[[nodiscard]] OptionInfo quiet_option();
[[nodiscard]] OptionInfo trust_option();
[[nodiscard]] OptionInfo copy_option();
[[nodiscard]] OptionInfo seed_option();
[[nodiscard]] OptionInfo threads_option();
[[nodiscard]] OptionInfo scene_argument();
[[nodiscard]] OptionInfo json_option(std::string_view help);
[[nodiscard]] OptionInfo output_option(std::string_view help);
[[nodiscard]] OptionInfo bvh_quality_option();
[[nodiscard]] OptionInfo bvh_compact_option();
[[nodiscard]] OptionInfo accel_option(std::string_view help, std::string default_value);
// A width or height.
[[nodiscard]] OptionInfo size_option(std::string_view name, std::string_view help,
                                     std::string default_value);
[[nodiscard]] OptionInfo transfer_option(std::string_view help);

}  // namespace dapple
