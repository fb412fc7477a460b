// Runs the plan of a study, round after round.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "dapple/scaling/workload.h"

namespace dapple::scaling {

struct StudySettings {
  std::vector<int> threads = {1};  // as tidy_thread_counts() leaves them
  int rounds = 5;
  bool pin = true;
  // Seconds in all for waiting until the machine is quiet and for repeating disturbed runs.
  double patience = 0;
};

struct Measurements {
  std::vector<Configuration> plan;
  std::vector<std::vector<Sample>> samples;  // for each configuration one a round
  std::vector<int> threads;
  int rounds = 0;
  bool pinned = false;  // every thread of every run
  int repeated = 0;     // runs that others disturbed, done again
};

// Others had more than this part of the machine's cores.
inline constexpr double kDisturbed = 0.05;

// The mean over all runs, by their length.
[[nodiscard]] Activity mean_activity(const Measurements& measurements);

// Called before each run, and while waiting, with the number of runs done and of all; an error ends
// the study.
using StudyProgress = std::function<Status(std::size_t done, std::size_t total)>;

// One round that does not count warms caches, pages and threads. Each round runs every
// configuration once and begins with another one, so that whatever else happens on the machine
// meets all of them alike. Of a run that was repeated the least disturbed one counts.
[[nodiscard]] Expected<Measurements> run_study(
    const std::vector<std::unique_ptr<Workload>>& workloads, const StudySettings& settings,
    const StudyProgress& progress);

}  // namespace dapple::scaling
