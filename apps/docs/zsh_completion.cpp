#include <fmt/format.h>

#include "docs/documents.h"

namespace dapple {
namespace {

// Text inside a single-quoted specification of _arguments.
std::string spec_text(std::string_view text) {
  std::string result;
  for (const char c : escape(text, "\\[]:"))
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result;
}

// What completes a value: ":message:action".
std::string action(const OptionInfo& option) {
  if (option.kind == ValueKind::flag && option.value.empty() && option.name[0] >= 'a') return "";
  const std::string name =
      option.value.empty() ? std::string(option.name) : std::string(option.value);
  const std::string words = value_words(option);
  if (option.kind == ValueKind::scene) return fmt::format(":{}:_dapple_scene", name);
  if (!words.empty()) return fmt::format(":{}:({})", name, words);
  return fmt::format(":{}:{}", name, takes_file(option) ? "_files" : " ");
}

std::string option_spec(const OptionInfo& option) {
  const std::string help = spec_text(option.help);
  const char* const value = option.kind == ValueKind::flag ? "" : "=";
  const char* const repeats = option.repeatable ? "*" : "";
  if (option.letter == 0) {
    return fmt::format("'{}--{}{}[{}]{}'", repeats, option.name, value, help, action(option));
  }
  const char* const joined = option.kind == ValueKind::flag ? "" : "+";
  const std::string both =
      option.repeatable ? "'*'" : fmt::format("'(-{0} --{1})'", option.letter, option.name);
  return fmt::format("{0}{{-{1}{2},--{3}{4}}}'[{5}]{6}'", both, option.letter, joined, option.name,
                     value, help, action(option));
}

std::string arguments_call(const CommandInfo& command) {
  std::string text = "_arguments -s -S";
  for (const OptionInfo& option : command.options) {
    text += " \\\n            " + option_spec(option);
  }
  int place = 1;
  for (const OptionInfo& argument : command.arguments) {
    text += fmt::format(" \\\n            '{}{}'", place++, action(argument));
  }
  return text;
}

}  // namespace

std::string zsh_completion(const CommandInfo& program) {
  std::string text = fmt::format("#compdef {}\n\n", program.name);
  text += fmt::format(
      "_{}_scene() {{\n    local -a scenes=({})\n    _alternative 'scenes:scene:compadd -a scenes' "
      "'files:file:_files'\n}}\n\n",
      program.name, value_words({.name = "SCENE", .kind = ValueKind::scene}));
  text += fmt::format("_{}() {{\n    local curcontext=\"$curcontext\" state line\n", program.name);
  text += "    typeset -A opt_args\n    _arguments -C";
  for (const OptionInfo& option : program.options) text += " \\\n        " + option_spec(option);
  text += " \\\n        '1:command:->command' '*::argument:->argument'\n    case $state in\n";
  text += "    command)\n        local -a commands=(\n";
  for (const CommandInfo& command : program.commands) {
    text +=
        fmt::format("            '{}:{}'\n", last_word(command.name), spec_text(command.summary));
  }
  text += "        )\n        _describe command commands\n        ;;\n    argument)\n";
  text += "        case $line[1] in\n";
  for (const CommandInfo& command : program.commands) {
    text += fmt::format("        {})\n            {}\n            ;;\n", last_word(command.name),
                        arguments_call(command));
  }
  text += "        esac\n        ;;\n    esac\n}\n\n";
  return text + fmt::format("_{0} \"$@\"\n", program.name);
}

}  // namespace dapple
