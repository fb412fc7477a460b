#include <fmt/format.h>

#include "docs/documents.h"

namespace dapple {
namespace {

std::string quoted(std::string_view text) { return fmt::format("'{}'", escape(text, "\\'")); }

// Files are offered only where -F says so.
std::string option_line(std::string_view start, const OptionInfo& option) {
  std::string line = fmt::format("{} -l {}", start, option.name);
  if (option.letter != 0) line += fmt::format(" -s {}", option.letter);
  if (option.kind != ValueKind::flag) line += takes_file(option) ? " -r -F" : " -x";
  const std::string words = value_words(option);
  if (!words.empty()) line += fmt::format(" -a {}", quoted(words));
  return fmt::format("{} -d {}\n", line, quoted(option.help));
}

std::string argument_line(std::string_view start, const OptionInfo& argument) {
  const std::string words = value_words(argument);
  std::string line(start);
  if (takes_file(argument)) line += " -F";
  if (!words.empty()) line += fmt::format(" -a {}", quoted(words));
  return line + "\n";
}

}  // namespace

std::string fish_completion(const CommandInfo& program) {
  std::string text = fmt::format("# fish completion for {0}\ncomplete -c {0} -f\n", program.name);
  const std::string before = fmt::format("complete -c {} -n __fish_use_subcommand", program.name);
  for (const OptionInfo& option : program.options) text += option_line(before, option);
  for (const CommandInfo& command : program.commands) {
    const std::string_view name = last_word(command.name);
    text += fmt::format("{} -a {} -d {}\n", before, name, quoted(command.summary));
    const std::string within =
        fmt::format("complete -c {} -n '__fish_seen_subcommand_from {}'", program.name, name);
    for (const OptionInfo& option : command.options) text += option_line(within, option);
    if (!command.arguments.empty()) text += argument_line(within, command.arguments[0]);
  }
  return text;
}

}  // namespace dapple
