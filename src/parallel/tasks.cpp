#include "parallel/tasks.h"

#include <omp.h>

#include <algorithm>
#include <utility>

#include "parallel/parallel.h"
#include "parallel/team_clock.h"
#include "util/float_mode.h"

namespace dapple {

void run_with_tasks(std::size_t work, const std::function<void()>& root, ThreadTimes* times) {
  const StandardFloatMode standard;
  const TeamClock clock(times, thread_count());
  if (work < kTeamWork) {
    const TeamClock::Member member(clock, 0);
    const WorkSpan span;
    return root();
  }
  std::exception_ptr exception;
#pragma omp parallel
  {
    const TeamClock::Member member(clock, omp_get_thread_num());
#pragma omp single
    try {
      const WorkSpan span;
      root();
    } catch (...) {
      exception = std::current_exception();
    }
  }
  if (exception) std::rethrow_exception(exception);
}

TaskGroup::~TaskGroup() {
  const WaitSpan waiting;
#pragma omp taskwait
}

void TaskGroup::keep_exception() {
  const std::lock_guard lock(mutex_);
  if (!exception_) exception_ = std::current_exception();
}

void TaskGroup::run(std::function<void()> task) {
#pragma omp task firstprivate(task)
  {
    try {
      const StandardFloatMode standard;
      const WorkSpan span;
      task();
    } catch (...) {
      keep_exception();
    }
  }
}

void TaskGroup::wait() {
  {
    const WaitSpan waiting;
#pragma omp taskwait
  }
  if (exception_) std::rethrow_exception(std::exchange(exception_, nullptr));
}

void parallel_for_chunks(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t, std::size_t)>& body) {
  TaskGroup tasks;
  for (std::size_t begin = 0; begin < count; begin += grain) {
    const std::size_t end = std::min(begin + grain, count);
    tasks.run([&body, begin, end] { body(begin, end); });
  }
  tasks.wait();
}

}  // namespace dapple
