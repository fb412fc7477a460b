#include "parallel/parallel.h"

#include <omp.h>

#include <atomic>
#include <exception>

#include "parallel/team_clock.h"
#include "util/float_mode.h"

namespace dapple {
namespace {

// An exception must not leave an OpenMP region: the first one is kept and thrown after it.
class FirstException {
 public:
  bool caught() const { return caught_.load(std::memory_order_relaxed); }
  void keep() {
    if (!caught_.exchange(true)) exception_ = std::current_exception();
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::atomic<bool> caught_{false};
  std::exception_ptr exception_;
};

}  // namespace

int thread_count() { return omp_get_max_threads(); }

void set_thread_count(int count) {
  static const int from_environment = omp_get_max_threads();
  omp_set_num_threads(count > 0 ? count : from_environment);
}

void parallel_for_dynamic(std::size_t count, const std::function<void(std::size_t)>& body,
                          ThreadTimes* times) {
  FirstException first;
  const TeamClock clock(times, thread_count());
#pragma omp parallel
  {
    const TeamClock::Member member(clock, omp_get_thread_num());
#pragma omp for schedule(dynamic, 1)
    for (std::size_t i = 0; i < count; ++i) {
      if (first.caught()) continue;
      try {
        const StandardFloatMode standard;
        const WorkSpan work;
        body(i);
      } catch (...) {
        first.keep();
      }
    }
  }
  first.rethrow();
}

}  // namespace dapple
