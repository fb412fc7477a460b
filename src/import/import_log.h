// Collects the warnings of an import: each once, and not without end.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace dapple {

class ImportLog {
 public:
  void warn(std::string text);
  // The warnings in the order they came.
  [[nodiscard]] std::vector<std::string> take();

 private:
  std::set<std::string> seen_;
  std::vector<std::string> warnings_;
  std::size_t left_out_ = 0;
};

}  // namespace dapple
