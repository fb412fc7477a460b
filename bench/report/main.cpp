// bench_report: the measurements of docs/report that are not scaling.
#include <fmt/format.h>

#include <algorithm>

#include "harness/command_line.h"
#include "report/duels.h"
#include "report/layout.h"
#include "report/schedules.h"
#include "report/visits.h"

namespace dapple::bench {
namespace {

struct Study {
  const char* name;
  Status (*run)(const std::string& folder);
};

constexpr Study kStudies[] = {{"layout", study_layout},
                              {"visits", study_visits},
                              {"schedules", study_schedules},
                              {"duels", study_duels}};

struct Options {
  std::vector<std::string> names;
  std::string folder = ".";
};

std::optional<int> read(int argc, char** argv, Options& o) {
  CommandLine line("Measures what docs/report shows besides scaling, into CSV files.");
  line.add_positional("studies", "layout, visits, schedules, duels; all unless given", o.names);
  line.add("--folder", "where the files go", o.folder);
  return line.parse(argc, argv);
}

Status run(const Options& options) {
  for (const Study& study : kStudies) {
    const bool wanted =
        options.names.empty() ||
        std::find(options.names.begin(), options.names.end(), study.name) != options.names.end();
    if (!wanted) continue;
    if (auto status = study.run(options.folder); !status) return status;
  }
  return {};
}

}  // namespace
}  // namespace dapple::bench

int main(int argc, char** argv) {
  dapple::bench::Options options;
  if (const auto code = dapple::bench::read(argc, argv, options)) return *code;
  const dapple::Status status = dapple::bench::run(options);
  if (status) return 0;
  fmt::print(stderr, "bench_report: {}\n", to_string(status.error()));
  return static_cast<int>(status.error().code);
}
