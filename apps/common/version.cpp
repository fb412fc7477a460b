#include "common/version.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "accel/kernels/dispatch.h"
#include "dapple/version.h"
#include "parallel/parallel.h"

namespace dapple {
namespace {

using Line = std::pair<std::string_view, std::string>;

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

std::vector<Line> build_lines() {
  return {
      {"ISA",
       fmt::format("{} (this processor has {})", kernels().isa, fmt::join(available_isas(), ", "))},
      {"compiler", compiler()},
      {"threads", fmt::format("{} (OpenMP {})", thread_count(), DAPPLE_OPENMP_VERSION)},
      {"libraries", DAPPLE_LIBRARY_VERSIONS},
  };
}

}  // namespace

std::string version_text(std::string_view program) {
  std::string text = fmt::format("{} {}\n", program, DAPPLE_VERSION);
  for (const auto& [label, value] : build_lines()) text += fmt::format("{:<11}{}\n", label, value);
  return text;
}

}  // namespace dapple
