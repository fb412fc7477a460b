// The only place with OpenMP: loops and tasks for the other modules.
#pragma once

#include <cstddef>
#include <functional>

#include "parallel/thread_times.h"

namespace dapple {

// Threads that a loop would use now: set_thread_count(), else OMP_NUM_THREADS, else all cores.
[[nodiscard]] int thread_count();
// 0 gives back the choice to OpenMP's environment variables.
void set_thread_count(int count);

// Calls body(i) for i in [0, count), handed out one at a time to whichever thread is free.
// An exception in the body ends the loop early and is thrown again here.
// `times`, if given, gets how long each thread was in the body.
void parallel_for_dynamic(std::size_t count, const std::function<void(std::size_t)>& body,
                          ThreadTimes* times = nullptr);

}  // namespace dapple
