// Which cores a measurement may use.
#pragma once

#include <sched.h>

#include <string_view>

namespace dapple::bench {

enum class Cores {
  one,  // one thread, pinned to one core
  all,  // as many threads as the process may use
};

[[nodiscard]] int thread_count_of(Cores cores);
[[nodiscard]] std::string_view cores_name(Cores cores);

// Sets dapple's thread count and the calling thread's affinity; the destructor puts both back.
// Threads inherit the affinity of the one that makes them, so pools must be made under `all`.
class CoreScope {
 public:
  explicit CoreScope(Cores cores);
  ~CoreScope();
  CoreScope(const CoreScope&) = delete;
  CoreScope& operator=(const CoreScope&) = delete;

 private:
  cpu_set_t before_;
};

}  // namespace dapple::bench
