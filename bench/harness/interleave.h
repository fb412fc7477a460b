// Things to compare are measured in turn, round after round, so that whatever else happens on the
// machine meets all of them alike.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "harness/samples.h"

namespace dapple::bench {

struct Task {
  std::string name;
  std::function<void()> prepare;  // before each run, not measured; may be empty
  std::function<void()> run;
  Cores cores = Cores::all;
};

enum class WarmUp { none, one_round };

// One Samples per task, in the order of the tasks, each with `rounds` runs. Each round begins
// with another task.
[[nodiscard]] std::vector<Samples> run_interleaved(std::span<const Task> tasks, int rounds,
                                                   WarmUp warm_up);

}  // namespace dapple::bench
