#include "tests/architecture/kernel_symbols.h"

#include <array>
#include <cstdio>
#include <regex>
#include <stdexcept>

#include "tests/architecture/source_tree.h"

namespace dapple::architecture {
namespace {

bool is_of_one_target(const std::string& symbols) {
  static const std::regex target_namespace(R"(\bN_[A-Z0-9_]+::)");
  return std::regex_search(symbols, target_namespace);
}

}  // namespace

std::vector<std::string> shared_weak_functions(const std::string& nm_output) {
  // "ADDRESS W NAME"; weak data ('V', 'u') has no instructions.
  static const std::regex weak_function(R"(^[0-9a-f]+ W (.+)$)");
  std::vector<std::string> names;
  for (const std::string& line : lines_of(nm_output)) {
    std::smatch match;
    if (!std::regex_match(line, match, weak_function)) continue;
    const std::string name = match[1];
    if (!is_of_one_target(name)) names.push_back(name);
  }
  return names;
}

bool holds_kernels(const std::string& nm_output) { return is_of_one_target(nm_output); }

std::string run_nm(const std::string& object) {
  FILE* pipe = popen(("nm -C --defined-only '" + object + "'").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start nm");
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe)) {
    output.append(buffer.data(), size);
  }
  if (pclose(pipe) != 0) throw std::runtime_error("nm failed on " + object);
  return output;
}

}  // namespace dapple::architecture
