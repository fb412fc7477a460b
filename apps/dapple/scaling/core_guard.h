// Keeps other programs off cores that a run does not use, so that what they do there does not slow
// the run down through shared caches or a shared core.
#pragma once

#include <pthread.h>

#include <atomic>
#include <thread>
#include <vector>

namespace dapple::scaling {

// On each of the cores a thread of ours waits with the processor's pause instruction, which leaves
// a core's shared parts nearly alone. Takes the whole core: for as short as it goes.
class CoreGuard {
 public:
  explicit CoreGuard(const std::vector<int>& cores);
  ~CoreGuard();
  CoreGuard(const CoreGuard&) = delete;
  CoreGuard& operator=(const CoreGuard&) = delete;

  // Processor time of its threads so far: not the run's.
  double cpu_seconds() const;

 private:
  std::atomic<bool> stop_{false};
  std::vector<std::jthread> threads_;
  std::vector<pthread_t> handles_;
};

}  // namespace dapple::scaling
