// SIGINT, SIGTERM and SIGHUP as a flag that long work looks at.
#pragma once

#include <atomic>

#include "util/error.h"

namespace dapple {

// From now on the first of these signals sets the flag; a second one ends the process at once. A
// signal that was being ignored stays ignored.
const std::atomic<bool>& catch_stop_signals();

// An `interrupted` error once the flag is set.
[[nodiscard]] Status check_stop();

}  // namespace dapple
