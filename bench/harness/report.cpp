#include "harness/report.h"

#include <fmt/format.h>

#include <span>

#include "harness/machine.h"
#include "util/atomic_file.h"

namespace dapple::bench {

Report::Report(std::string name) {
  document_["bench"] = std::move(name);
  document_["machine"] = describe_machine();
  document_["warnings"] = nlohmann::json::array();
  const nlohmann::json& machine = document_["machine"];
  fmt::print("{}, {} cores, {}, {}\n", machine["processor"].get<std::string>(),
             machine["cores"].get<int>(), machine["compiler"].get<std::string>(),
             machine["flags"].get<std::string>());
  const double load = load_average();
  if (load > 0.5) {
    warn(fmt::format("other work is running on this machine: load average {:.1f}", load));
  }
}

void Report::add(const std::string& kind, nlohmann::json row) {
  document_["results"][kind].push_back(std::move(row));
}

void Report::print(const std::string& title, const Table& table) const {
  fmt::print("\n{}\n{}", title, table.text());
  std::fflush(stdout);
}

void Report::check_noise(const std::string& what, const Samples& samples) {
  if (samples.spread() <= kNoisySpread) return;
  warn(fmt::format("{}: runs differ by {:.0f} %", what, 100 * samples.spread()));
}

void Report::warn(const std::string& message) {
  fmt::print(stderr, "warning: {}\n", message);
  document_["warnings"].push_back(message);
}

Status Report::write(const std::string& path) const {
  if (path.empty()) return {};
  const std::string text = document_.dump(1) + "\n";
  return write_file_atomically(path, std::as_bytes(std::span(text)));
}

nlohmann::json to_json(const Samples& samples) {
  nlohmann::json runs = nlohmann::json::array();
  for (const Seconds& run : samples.runs) runs.push_back({{"wall", run.wall}, {"cpu", run.cpu}});
  return {{"name", samples.name},
          {"threads", thread_count_of(samples.cores)},
          {"clock", samples.cores == Cores::one ? "cpu" : "wall"},
          {"median_s", samples.median()},
          {"spread", samples.spread()},
          {"runs", std::move(runs)}};
}

nlohmann::json to_json(const Ratio& ratio) {
  return {{"median", ratio.median}, {"low", ratio.low}, {"high", ratio.high}};
}

std::string to_text(const Ratio& ratio) {
  return fmt::format("{:.2f} ({:.2f}-{:.2f})", ratio.median, ratio.low, ratio.high);
}

}  // namespace dapple::bench
