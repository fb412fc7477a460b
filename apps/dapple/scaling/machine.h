// On what machine a study ran.
#pragma once

#include <string>

#include "dapple/scaling/activity.h"

namespace dapple::scaling {

struct Machine {
  std::string processor;
  int cores = 0;         // that this process may use
  int cores_online = 0;  // of the machine
  double memory_gib = 0;
  std::string system;
  std::string isa;                         // the kernels' instruction set
  double load_before = 0, load_after = 0;  // mean number of runnable threads of the last minute
  Activity activity;                       // of others, during the runs that count
};

// As it is now; the load after the study and the activity during it are for the caller to add.
[[nodiscard]] Machine describe_machine();
// Mean number of runnable threads of the last minute, this process included.
[[nodiscard]] double load_average();

}  // namespace dapple::scaling
