// Options of the benchmark programs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace dapple::bench {

class CommandLine {
 public:
  explicit CommandLine(const std::string& summary);
  ~CommandLine();

  // The variable's value is the default and must live until parse() has returned.
  void add(const std::string& flag, const std::string& help, std::string& value);
  void add(const std::string& flag, const std::string& help, int& value);
  // Set by naming it.
  void add(const std::string& flag, const std::string& help, bool& value);
  void add_positional(const std::string& name, const std::string& help,
                      std::vector<std::string>& values);

  // The exit code when the program should end now: after --help, or a wrong option.
  [[nodiscard]] std::optional<int> parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace dapple::bench
