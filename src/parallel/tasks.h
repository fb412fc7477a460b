// Tasks for recursive work: trees that split into independent halves.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

#include "parallel/thread_times.h"

namespace dapple {

// Runs `root` with a team of threads that take the tasks it creates; on this thread alone when
// there are fewer than kTeamWork things to work on, for which a team would cost more than it gives.
// `times`, if given, gets how long each thread was at work and not waiting for tasks.
inline constexpr std::size_t kTeamWork = 1024;
void run_with_tasks(std::size_t work, const std::function<void()>& root,
                    ThreadTimes* times = nullptr);

// Tasks that are waited for together. Used inside run_with_tasks; outside it, tasks run at once.
class TaskGroup {
 public:
  TaskGroup() = default;
  TaskGroup(const TaskGroup&) = delete;
  TaskGroup& operator=(const TaskGroup&) = delete;
  ~TaskGroup();

  void run(std::function<void()> task);
  // Returns when every task of the group has ended; throws the first exception of one.
  void wait();

 private:
  void keep_exception();

  std::mutex mutex_;
  std::exception_ptr exception_;
};

// body(begin, end) over [0, count) in pieces of `grain`, as tasks. The pieces do not depend on the
// number of threads.
void parallel_for_chunks(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace dapple
