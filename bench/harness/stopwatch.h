// Time on the wall and time on the processor.
#pragma once

#include <chrono>
#include <ctime>

namespace dapple::bench {

struct Seconds {
  double wall = 0;
  double cpu = 0;  // of all threads of the process together
};

inline Seconds now() {
  std::timespec cpu{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration<double>(wall).count(),
          static_cast<double>(cpu.tv_sec) + 1e-9 * static_cast<double>(cpu.tv_nsec)};
}

class Stopwatch {
 public:
  Seconds elapsed() const {
    const Seconds end = now();
    return {end.wall - start_.wall, end.cpu - start_.cpu};
  }

 private:
  Seconds start_ = now();
};

}  // namespace dapple::bench
