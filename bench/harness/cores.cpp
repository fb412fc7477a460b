#include "harness/cores.h"

#include "parallel/parallel.h"

namespace dapple::bench {
namespace {

cpu_set_t allowed_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof(set), &set);
  return set;
}

// The last one: the first serves most interrupts.
cpu_set_t last_of(const cpu_set_t& allowed) {
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int core = CPU_SETSIZE - 1; core >= 0; --core) {
    if (!CPU_ISSET(core, &allowed)) continue;
    CPU_SET(core, &one);
    break;
  }
  return one;
}

// What the environment and the machine allow, read before any measurement changes it.
int default_thread_count() {
  static const int count = thread_count();
  return count;
}

}  // namespace

int thread_count_of(Cores cores) { return cores == Cores::one ? 1 : default_thread_count(); }

std::string_view cores_name(Cores cores) { return cores == Cores::one ? "one core" : "all cores"; }

CoreScope::CoreScope(Cores cores) : before_(allowed_cores()) {
  default_thread_count();
  set_thread_count(thread_count_of(cores));
  if (cores == Cores::one) {
    const cpu_set_t one = last_of(before_);
    sched_setaffinity(0, sizeof(one), &one);
  }
}

CoreScope::~CoreScope() {
  sched_setaffinity(0, sizeof(before_), &before_);
  set_thread_count(default_thread_count());
}

}  // namespace dapple::bench
