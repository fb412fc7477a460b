#include "harness/machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/cores.h"

namespace dapple::bench {
namespace {

// The value of the first line "KEY : VALUE" of a file of /proc; empty when there is none.
std::string proc_value(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (line.rfind(key, 0) != 0 || colon == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

std::string first_line(const char* path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

bool has_flag(const char* name) {
  static const std::string flags = fmt::format(" {} ", proc_value("/proc/cpuinfo", "flags"));
  return flags.find(fmt::format(" {} ", name)) != std::string::npos;
}

std::string vector_instructions() {
  std::string result;
  for (const char* name : {"sse4_2", "avx2", "fma", "avx512f", "avx512vl", "avx512bw"}) {
    if (has_flag(name)) result += fmt::format("{}{}", result.empty() ? "" : " ", name);
  }
  return result;
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

std::string system_name() {
  utsname name{};
  uname(&name);
  return fmt::format("{} {}", name.sysname, name.release);
}

double memory_gib() {
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  return pages * static_cast<double>(sysconf(_SC_PAGE_SIZE)) / (1 << 30);
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

nlohmann::json describe_machine() {
  return {
      {"processor", proc_value("/proc/cpuinfo", "model name")},
      {"cores", sysconf(_SC_NPROCESSORS_ONLN)},
      {"threads_used", thread_count_of(Cores::all)},
      {"mhz_at_start", proc_value("/proc/cpuinfo", "cpu MHz")},
      {"frequency_governor", first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")},
      {"last_level_cache", first_line("/sys/devices/system/cpu/cpu0/cache/index3/size")},
      {"huge_pages", first_line("/sys/kernel/mm/transparent_hugepage/enabled")},
      {"memory_gib", memory_gib()},
      {"system", system_name()},
      {"virtual_machine", has_flag("hypervisor")},
      {"vector_instructions", vector_instructions()},
      {"forced_isa", environment("DAPPLE_ISA")},
      {"compiler", compiler()},
      {"build_type", DAPPLE_BENCH_BUILD_TYPE},
      {"flags", DAPPLE_BENCH_FLAGS},
      {"load_at_start", load_average()},
  };
}

}  // namespace dapple::bench
