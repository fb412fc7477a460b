#include "dapple/scaling/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace dapple::scaling {
namespace {

constexpr std::array<std::string_view, 3> kWorkNames = {"ray", "ray_bvh", "build"};

}  // namespace

std::string_view work_name(WorkKind kind) { return kWorkNames[static_cast<std::size_t>(kind)]; }

std::string_view mode_name(Mode mode) { return mode == Mode::strong ? "strong" : "weak"; }

std::string_view growth_name(WorkKind kind) {
  return kind == WorkKind::build ? "objects" : "samples";
}

Expected<WorkKind> parse_work(std::string_view name) {
  for (std::size_t i = 0; i < kWorkNames.size(); ++i) {
    if (kWorkNames[i] == name) return static_cast<WorkKind>(i);
  }
  return fail(Errc::usage, std::string(name),
              fmt::format("unknown work; there are {}", fmt::join(kWorkNames, ", ")));
}

Configuration configuration_of(WorkKind work, Mode mode, int threads) {
  return {work, threads, mode == Mode::strong ? 1 : threads};
}

std::vector<Configuration> make_plan(std::span<const WorkKind> works,
                                     std::span<const int> threads) {
  std::vector<Configuration> plan;
  for (const WorkKind work : works) {
    for (const int count : threads) {
      for (const Mode mode : {Mode::strong, Mode::weak}) {
        const Configuration next = configuration_of(work, mode, count);
        if (std::find(plan.begin(), plan.end(), next) == plan.end()) plan.push_back(next);
      }
    }
  }
  return plan;
}

std::vector<int> tidy_thread_counts(std::vector<int> threads) {
  threads.push_back(1);
  std::sort(threads.begin(), threads.end());
  threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
  return threads;
}

std::vector<int> default_thread_counts(int cores) {
  std::vector<int> threads = {cores};
  for (int count = 1; count < cores; count *= 2) threads.push_back(count);
  return tidy_thread_counts(std::move(threads));
}

}  // namespace dapple::scaling
