#include "parallel/pinning.h"

#include <omp.h>

#include <atomic>

#include "parallel/parallel.h"

namespace dapple {
namespace {

cpu_set_t affinity() {
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof(set), &set);
  return set;
}

cpu_set_t only(int core) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(core, &set);
  return set;
}

}  // namespace

std::vector<int> allowed_cores() {
  const cpu_set_t set = affinity();
  std::vector<int> cores;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  }
  return cores;
}

PinnedTeam::PinnedTeam(int threads) : threads_before_(thread_count()), cores_before_(affinity()) {
  set_thread_count(threads);
  const std::vector<int> cores = allowed_cores();
  std::atomic<bool> refused{cores.empty()};
  // OpenMP keeps the threads of a team, and their numbers, for the next team of the same size.
#pragma omp parallel
  if (!cores.empty()) {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const cpu_set_t core = only(cores[thread % cores.size()]);
    if (sched_setaffinity(0, sizeof(core), &core) != 0) refused = true;
  }
  pinned_ = !refused;
}

PinnedTeam::~PinnedTeam() {
#pragma omp parallel
  sched_setaffinity(0, sizeof(cores_before_), &cores_before_);
  set_thread_count(threads_before_);
}

}  // namespace dapple
