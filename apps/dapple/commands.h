// The subcommands: each runs with checked arguments and gives the exit code of a success.
#pragma once

#include "dapple/arguments.h"

namespace dapple {

[[nodiscard]] Expected<int> run_bench(const Arguments& arguments);
[[nodiscard]] Expected<int> run_compare(const Arguments& arguments);
[[nodiscard]] Expected<int> run_convert(const Arguments& arguments);
[[nodiscard]] Expected<int> run_info(const Arguments& arguments);
[[nodiscard]] Expected<int> run_render(const Arguments& arguments);
[[nodiscard]] Expected<int> run_scaling(const Arguments& arguments);
[[nodiscard]] Expected<int> run_scenes(const Arguments& arguments);

using CommandFunction = Expected<int> (*)(const Arguments& arguments);

// The function of a command of dapple_program(), by its last word.
[[nodiscard]] CommandFunction command_function(std::string_view name);

// The whole of `dapple`: the exit code for the words after the program's name.
[[nodiscard]] int run_dapple(const std::vector<std::string>& words);

}  // namespace dapple
