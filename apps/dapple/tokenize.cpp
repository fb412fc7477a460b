// The only source that includes CLI11, which is slow to compile.
#include "dapple/tokenize.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace dapple {
namespace {

std::string names_of(const OptionInfo& option) {
  if (option.letter == 0) return fmt::format("--{}", option.name);
  return fmt::format("-{},--{}", option.letter, option.name);
}

CLI::Option* add_option(CLI::App& app, const OptionInfo& option) {
  CLI::Option* const added =
      option.kind == ValueKind::flag
          ? app.add_flag(names_of(option))->disable_flag_override()
          : app.add_option(names_of(option))->expected(1)->allow_extra_args(false);
  return added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

// CLI11 would take the next word for the value of "--name=".
Status check_empty_values(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word.starts_with("--") && word.find('=') == word.size() - 1) {
      return fail(Errc::usage, word, "the value after '=' is empty");
    }
  }
  return {};
}

// With each argument told to CLI11, only what is no option or too much remains.
void sort_remaining(const std::vector<std::string>& words, Tokens& tokens) {
  for (const std::string& word : words) {
    const bool is_option = word.size() > 1 && word[0] == '-';
    (is_option ? tokens.unknown : tokens.arguments).push_back(word);
  }
}

}  // namespace

Expected<Tokens> tokenize(const CommandInfo& command, const std::vector<std::string>& words) try {
  if (auto status = check_empty_values(words); !status) return tl::unexpected(status.error());
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::vector<CLI::Option*> options, arguments;
  for (const OptionInfo& option : command.options) options.push_back(add_option(app, option));
  for (const OptionInfo& argument : command.arguments) {
    arguments.push_back(
        app.add_option(std::string(argument.name))->expected(1)->allow_extra_args(false));
  }
  app.parse(std::vector<std::string>(words.rbegin(), words.rend()));

  Tokens tokens;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i]->count() == 0) continue;
    tokens.options[std::string(command.options[i].name)] = options[i]->results();
  }
  for (const CLI::Option* argument : arguments) {
    if (argument->count() > 0) tokens.arguments.push_back(argument->results()[0]);
  }
  sort_remaining(app.remaining(), tokens);
  return tokens;
} catch (const CLI::Error& error) {
  return fail(Errc::usage, "", error.what());
}

}  // namespace dapple
