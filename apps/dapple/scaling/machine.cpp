#include "dapple/scaling/machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <vector>

#include "accel/kernels/dispatch.h"
#include "parallel/pinning.h"

namespace dapple::scaling {
namespace {

// The value of the first line "KEY : VALUE"; empty when there is none.
std::string proc_value(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with(key) || colon == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

double seconds_of(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Machine describe_machine() {
  utsname name{};
  uname(&name);
  Machine machine;
  machine.processor = proc_value("/proc/cpuinfo", "model name");
  machine.cores = static_cast<int>(allowed_cores().size());
  machine.cores_online = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  machine.memory_gib = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<double>(sysconf(_SC_PAGE_SIZE)) / (1 << 30);
  machine.system = fmt::format("{} {}", name.sysname, name.release);
  machine.isa = kernels().isa;
  machine.load_before = load_average();
  return machine;
}

ActivityMeter::ActivityMeter() : start_(read()) {}

// The line "cpu user nice system idle iowait irq softirq steal ..." of /proc/stat, in clock ticks.
ActivityMeter::Reading ActivityMeter::read() {
  Reading reading;
  reading.wall = seconds_of(CLOCK_MONOTONIC);
  reading.own = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  std::ifstream file("/proc/stat");
  std::string label;
  std::vector<double> ticks(8);
  file >> label;
  for (double& value : ticks) file >> value;
  if (!file || label != "cpu") return reading;
  const double second = static_cast<double>(sysconf(_SC_CLK_TCK));
  reading.busy = (ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6]) / second;
  reading.stolen = ticks[7] / second;
  return reading;
}

void ActivityMeter::finish(Machine& machine) const {
  const Reading end = read();
  const double wall = end.wall - start_.wall;
  const double others = (end.busy - start_.busy) - (end.own - start_.own);
  machine.load_after = load_average();
  machine.other_cores = std::max(0.0, others / wall);
  machine.stolen_cores = (end.stolen - start_.stolen) / wall;
}

}  // namespace dapple::scaling
