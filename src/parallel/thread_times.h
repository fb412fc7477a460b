// How long each thread of a team was at work: what studies of load balance ask for. A loop or a
// team of tasks that is given none measures nothing.
#pragma once

#include <cstddef>
#include <vector>

namespace dapple {

struct BusyTime {
  double wall = 0;         // seconds in pieces of work, as the clock on the wall counts
  double cpu = 0;          // of these, on a processor
  std::size_t pieces = 0;  // loop iterations or tasks
};

class ThreadTimes {
 public:
  // One entry a thread, in the order of OpenMP's thread numbers.
  std::vector<BusyTime> busy() const;

 private:
  friend class TeamClock;

  // A cache line of its own for each thread.
  struct alignas(64) Slot {
    BusyTime busy;
  };
  std::vector<Slot> slots_;
};

}  // namespace dapple
