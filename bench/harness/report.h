// What a benchmark leaves behind: tables and warnings on standard output, all figures as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "harness/samples.h"
#include "harness/table.h"
#include "util/error.h"

namespace dapple::bench {

class Report {
 public:
  explicit Report(std::string name);

  // One figure or group of figures; `kind` says which table it belongs to.
  void add(const std::string& kind, nlohmann::json row);
  void print(const std::string& title, const Table& table) const;
  // Warns when the runs differ much among each other.
  void check_noise(const std::string& what, const Samples& samples);
  void warn(const std::string& message);

  // Nothing is written when `path` is empty.
  [[nodiscard]] Status write(const std::string& path) const;

 private:
  nlohmann::json document_;
};

// Median, spread and every run, in seconds.
[[nodiscard]] nlohmann::json to_json(const Samples& samples);
[[nodiscard]] nlohmann::json to_json(const Ratio& ratio);

// "2.31 (2.28-2.40)"
[[nodiscard]] std::string to_text(const Ratio& ratio);

}  // namespace dapple::bench
