// A table on its way into a file of comma-separated values.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <string>
#include <vector>

#include "util/atomic_file.h"

namespace dapple::bench {

class CsvFile {
 public:
  explicit CsvFile(const std::vector<std::string>& header) { add_fields(header); }

  template <class... Fields>
  void add(const Fields&... fields) {
    add_fields({fmt::format("{}", fields)...});
  }

  [[nodiscard]] Status write(const std::string& path) const {
    return write_file_atomically(path, std::as_bytes(std::span(text_)));
  }

 private:
  void add_fields(const std::vector<std::string>& fields) {
    text_ += fmt::format("{}\n", fmt::join(fields, ","));
  }

  std::string text_;
};

// As many digits as a measurement deserves.
inline std::string digits(double value) { return fmt::format("{:.4g}", value); }

}  // namespace dapple::bench
