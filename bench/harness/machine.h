// On what a measurement was made.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace dapple::bench {

// Processor, cores, caches, memory, system, compiler and its flags, vector instructions, load.
[[nodiscard]] nlohmann::json describe_machine();

// Mean number of runnable threads of the last minute, this process included.
[[nodiscard]] double load_average();

}  // namespace dapple::bench
