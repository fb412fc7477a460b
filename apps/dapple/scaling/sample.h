// What one run leaves behind.
#pragma once

#include <algorithm>
#include <vector>

#include "dapple/scaling/activity.h"
#include "parallel/thread_times.h"

namespace dapple::scaling {

struct Sample {
  double wall = 0;             // seconds
  double cpu = 0;              // seconds of all threads of the process together
  std::vector<BusyTime> busy;  // thread by thread
  Activity activity;           // of others meanwhile; the study fills it in

  // The longest busy time of a thread over the mean: 1 when all end together.
  double imbalance() const {
    double longest = 0, sum = 0;
    for (const BusyTime& thread : busy) {
      longest = std::max(longest, thread.wall);
      sum += thread.wall;
    }
    return sum == 0 ? 1 : longest * static_cast<double>(busy.size()) / sum;
  }
};

}  // namespace dapple::scaling
