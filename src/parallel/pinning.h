// Threads tied to cores, for measurements: a thread that wanders loses its caches, and two on one
// core look like bad scaling.
#pragma once

#include <sched.h>

#include <vector>

namespace dapple {

// The cores this process may use, in ascending order.
[[nodiscard]] std::vector<int> allowed_cores();

// Ties thread i of a team of `threads` to the i-th allowed core, from the first again when there
// are more threads than cores; sets the thread count. The destructor gives back both, for the
// threads of this team. One at a time, made by the thread that starts the loops.
class PinnedTeam {
 public:
  explicit PinnedTeam(int threads);
  ~PinnedTeam();
  PinnedTeam(const PinnedTeam&) = delete;
  PinnedTeam& operator=(const PinnedTeam&) = delete;

  // False when the system refused for a thread; that one runs where it likes.
  bool pinned() const { return pinned_; }

 private:
  int threads_before_;
  cpu_set_t cores_before_;
  bool pinned_ = true;
};

}  // namespace dapple
