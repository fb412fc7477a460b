#include "common/help.h"

#include <fmt/format.h>

namespace dapple {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kHelpColumn = 26;

std::string option_head(const OptionInfo& option) {
  const std::string letter = option.letter ? fmt::format("-{}, ", option.letter) : "    ";
  const std::string value = value_text(option);
  return fmt::format("  {}--{}{}{}", letter, option.name, value.empty() ? "" : " ", value);
}

// The head, and the help text in a column beside it or below it.
std::string entry(const std::string& head, std::string_view help) {
  const std::string text = wrap(help, kWidth - kHelpColumn, kHelpColumn);
  if (head.size() + 2 <= kHelpColumn) return fmt::format("{:<{}}{}\n", head, kHelpColumn, text);
  return fmt::format("{}\n{:{}}{}\n", head, "", kHelpColumn, text);
}

void add_examples(const CommandInfo& command, std::string& page) {
  if (command.examples.empty()) return;
  page += "\nExamples:\n";
  for (const Example& example : command.examples) {
    page += fmt::format("  {}\n      {}\n", example.command, wrap(example.meaning, kWidth - 6, 6));
  }
}

}  // namespace

std::string wrap(std::string_view text, std::size_t width, std::size_t indent) {
  std::string result;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const bool breaks = column > 0 && column + 1 + end > width;
    if (breaks) {
      result += '\n' + std::string(indent, ' ');
      column = 0;
    } else if (column > 0) {
      result += ' ';
      ++column;
    }
    result += text.substr(0, end);
    column += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string help_page(const CommandInfo& command) {
  std::string page = fmt::format("usage: {}\n\n", synopsis(command));
  for (const std::string_view paragraph : command.paragraphs) {
    page += wrap(paragraph, kWidth, 0) + "\n\n";
  }
  if (!command.arguments.empty()) page += "Arguments:\n";
  for (const OptionInfo& argument : command.arguments) {
    page += entry(fmt::format("  {}", argument.name), help_text(argument));
  }
  if (!command.commands.empty()) page += "\nCommands:\n";
  for (const CommandInfo& each : command.commands) {
    page += entry(fmt::format("  {}", last_word(each.name)), each.summary);
  }
  if (!command.options.empty()) page += "\nOptions:\n";
  for (const OptionInfo& option : command.options) {
    page += entry(option_head(option), help_text(option));
  }
  add_examples(command, page);
  return page;
}

}  // namespace dapple
