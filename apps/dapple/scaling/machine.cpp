#include "dapple/scaling/machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

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

}  // namespace

double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

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

}  // namespace dapple::scaling
