#include "common/command_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace dapple {

const CommandInfo& classic_program(std::string_view name) {
  const auto& programs = classic_programs();
  const auto found = std::find_if(programs.begin(), programs.end(),
                                  [&](const CommandInfo& program) { return program.name == name; });
  if (found == programs.end()) throw std::logic_error("no program " + std::string(name));
  return *found;
}

std::string_view last_word(std::string_view name) { return name.substr(name.rfind(' ') + 1); }

std::string value_text(const OptionInfo& option) {
  if (option.kind == ValueKind::choice) return fmt::format("{}", fmt::join(option.choices, "|"));
  return std::string(option.value);
}

std::string synopsis(const CommandInfo& command) {
  std::string text(command.name);
  const auto optional = [](const OptionInfo& option) { return !option.required; };
  if (std::any_of(command.options.begin(), command.options.end(), optional)) {
    text += " [OPTION]...";
  }
  for (const OptionInfo& argument : command.arguments) {
    text +=
        argument.required ? fmt::format(" {}", argument.name) : fmt::format(" [{}]", argument.name);
  }
  for (const OptionInfo& option : command.options) {
    if (option.required) text += fmt::format(" --{} {}", option.name, value_text(option));
  }
  return text;
}

std::string help_text(const OptionInfo& option) {
  std::vector<std::string> notes;
  if (option.kind == ValueKind::integer || option.kind == ValueKind::integers) {
    notes.push_back(fmt::format("{} to {}", option.low, option.high));
  }
  if (!option.default_value.empty()) notes.push_back("default " + option.default_value);
  if (option.repeatable) notes.push_back("may be given several times");
  if (notes.empty()) return std::string(option.help);
  return fmt::format("{} ({})", option.help, fmt::join(notes, "; "));
}

}  // namespace dapple
