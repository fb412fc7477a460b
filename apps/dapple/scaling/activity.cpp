#include "dapple/scaling/activity.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <string>

namespace dapple::scaling {
namespace {

double seconds_of(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

// The line "cpu user nice system idle iowait irq softirq steal ..." of /proc/stat, in clock ticks.
ActivityMeter::Reading ActivityMeter::read() {
  Reading reading;
  reading.wall = seconds_of(CLOCK_MONOTONIC);
  reading.own = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  std::ifstream file("/proc/stat");
  std::string label;
  std::array<double, 8> ticks{};
  file >> label;
  for (double& value : ticks) file >> value;
  if (!file || label != "cpu") return reading;
  const auto second = static_cast<double>(sysconf(_SC_CLK_TCK));
  reading.busy = (ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6]) / second;
  reading.stolen = ticks[7] / second;
  return reading;
}

Activity ActivityMeter::elapsed() const {
  const Reading end = read();
  const double wall = std::max(end.wall - start_.wall, 1e-9);
  const double others = (end.busy - start_.busy) - (end.own - start_.own);
  return {std::max(0.0, others / wall), (end.stolen - start_.stolen) / wall};
}

}  // namespace dapple::scaling
