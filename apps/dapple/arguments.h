// A command line, read by the table of its command.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/command_table.h"
#include "util/error.h"

namespace dapple {

// The values that were given, all checked against the table. Asking for a name that is not in
// the command's table is a bug and throws.
class Arguments {
 public:
  explicit Arguments(const CommandInfo& command) : command_(&command) {}

  const CommandInfo& command() const { return *command_; }

  // True when the option or argument was given.
  bool given(std::string_view name) const;
  // What was given last, else the default.
  std::string text(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  int small_integer(std::string_view name) const;  // for options whose range fits an int
  // Of an option that takes several, of which the table says that they fit an int.
  std::vector<int> integers(std::string_view name) const;
  double number(std::string_view name) const;
  double real(std::string_view name) const;
  std::array<double, 3> triple(std::string_view name) const;
  // Everything that was given, else the default alone.
  std::vector<std::string> texts(std::string_view name) const;

 private:
  friend class ArgumentReader;

  const CommandInfo* command_;
  std::map<std::string, std::vector<std::string>, std::less<>> values_;
};

// Reads what follows the command's name. Required values are only required without --help and
// --version.
[[nodiscard]] Expected<Arguments> read_arguments(const CommandInfo& command,
                                                 const std::vector<std::string>& words);

// The subcommand of that name; an unknown one is an error that names the nearest and lists all.
[[nodiscard]] Expected<const CommandInfo*> find_command(const CommandInfo& program,
                                                        std::string_view name);

}  // namespace dapple
