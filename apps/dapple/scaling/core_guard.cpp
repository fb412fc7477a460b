#include "dapple/scaling/core_guard.h"

#include <pthread.h>
#include <sched.h>

#include <ctime>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace dapple::scaling {
namespace {

void pause_a_moment() {
#if defined(__x86_64__)
  _mm_pause();
#endif
}

void stay_on(int core) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(core, &set);
  sched_setaffinity(0, sizeof(set), &set);
}

}  // namespace

CoreGuard::CoreGuard(const std::vector<int>& cores) {
  for (const int core : cores) {
    threads_.emplace_back([this, core] {
      stay_on(core);
      while (!stop_.load(std::memory_order_relaxed)) pause_a_moment();
    });
    handles_.push_back(threads_.back().native_handle());
  }
}

CoreGuard::~CoreGuard() { stop_ = true; }

double CoreGuard::cpu_seconds() const {
  double sum = 0;
  for (const pthread_t thread : handles_) {
    clockid_t clock{};
    std::timespec time{};
    if (pthread_getcpuclockid(thread, &clock) != 0 || clock_gettime(clock, &time) != 0) continue;
    sum += static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  return sum;
}

}  // namespace dapple::scaling
