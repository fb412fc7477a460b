#include "harness/command_line.h"

#include <CLI/CLI.hpp>

namespace dapple::bench {

CommandLine::CommandLine(const std::string& summary) : app_(std::make_unique<CLI::App>(summary)) {}
CommandLine::~CommandLine() = default;

void CommandLine::add(const std::string& flag, const std::string& help, std::string& value) {
  app_->add_option(flag, value, help)->capture_default_str();
}

void CommandLine::add(const std::string& flag, const std::string& help, int& value) {
  app_->add_option(flag, value, help)->check(CLI::PositiveNumber)->capture_default_str();
}

void CommandLine::add(const std::string& flag, const std::string& help, bool& value) {
  app_->add_flag(flag, value, help);
}

void CommandLine::add_positional(const std::string& name, const std::string& help,
                                 std::vector<std::string>& values) {
  app_->add_option(name, values, help)->capture_default_str();
}

std::optional<int> CommandLine::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app_->exit(error);
    return code == 0 ? 0 : 64;
  }
  return std::nullopt;
}

}  // namespace dapple::bench
