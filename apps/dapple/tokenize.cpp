// The only source that includes CLI11, which is slow to compile.
#include "dapple/tokenize.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

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

bool is_flag(const CommandInfo& command, std::string_view name) {
  return std::any_of(command.options.begin(), command.options.end(), [&](const OptionInfo& option) {
    return option.name == name && option.kind == ValueKind::flag;
  });
}

// What CLI11 would say less clearly, or, for "--name=", take the next word for.
Status check_joined_values(const CommandInfo& command, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    const std::size_t equals = word.find('=');
    if (!word.starts_with("--") || equals == std::string::npos) continue;
    if (is_flag(command, std::string_view(word).substr(2, equals - 2))) {
      return fail(Errc::usage, word, "this option takes no value");
    }
    if (equals + 1 == word.size()) return fail(Errc::usage, word, "the value is empty");
  }
  return {};
}

// With each argument told to CLI11, only what is no option or too much remains, and the "--".
void sort_remaining(const std::vector<std::string>& words, Tokens& tokens) {
  bool options_end = false;
  for (const std::string& word : words) {
    if (!options_end && word == "--") {
      options_end = true;
    } else if (!options_end && word.size() > 1 && word[0] == '-') {
      tokens.unknown.push_back(word);
    } else {
      tokens.arguments.push_back(word);
    }
  }
}

}  // namespace

Expected<Tokens> tokenize(const CommandInfo& command, const std::vector<std::string>& words) try {
  if (auto status = check_joined_values(command, words); !status)
    return tl::unexpected(status.error());
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
} catch (const CLI::ArgumentMismatch&) {
  return fail(Errc::usage, words.back(), "the value of this option is missing");
} catch (const CLI::Error& error) {
  return fail(Errc::usage, "", error.what());
}

}  // namespace dapple
