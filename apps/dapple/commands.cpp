#include "dapple/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "common/help.h"
#include "common/program.h"
#include "common/standard_output.h"
#include "common/version.h"

namespace dapple {
namespace {

constexpr std::array<std::pair<std::string_view, CommandFunction>, 7> kFunctions = {{
    {"bench", run_bench},
    {"compare", run_compare},
    {"convert", run_convert},
    {"info", run_info},
    {"render", run_render},
    {"scaling", run_scaling},
    {"scenes", run_scenes},
}};

Expected<int> print_page(const std::string& text) {
  return print_output(text).map([] { return 0; });
}

// Every usage error ends with the way to help.
Error with_hint(Error error, const CommandInfo& command) {
  if (error.code == Errc::usage) error.message += fmt::format(" (see {} --help)", command.name);
  return error;
}

Expected<int> run_command(const CommandInfo& command, const std::vector<std::string>& words) {
  const auto arguments = read_arguments(command, words);
  if (!arguments) return tl::unexpected(with_hint(arguments.error(), command));
  if (arguments->given("help")) return print_page(help_page(command));
  auto result = command_function(last_word(command.name))(*arguments);
  if (!result) return tl::unexpected(with_hint(result.error(), command));
  return result;
}

Expected<int> run_words(const std::vector<std::string>& words) {
  const CommandInfo& program = dapple_program();
  // What stands before the first word that is no option belongs to `dapple` itself.
  const auto name = std::find_if(words.begin(), words.end(),
                                 [](const std::string& word) { return !word.starts_with('-'); });
  const auto own = read_arguments(program, {words.begin(), name == words.end() ? name : name + 1});
  if (!own) return tl::unexpected(with_hint(own.error(), program));
  if (own->given("help")) return print_page(help_page(program));
  if (own->given("version")) return print_page(version_text(program.name));
  const auto command = find_command(program, *name);
  if (!command) return tl::unexpected(with_hint(command.error(), program));
  return run_command(**command, {name + 1, words.end()});
}

}  // namespace

CommandFunction command_function(std::string_view name) {
  for (const auto& [known, function] : kFunctions) {
    if (known == name) return function;
  }
  throw std::logic_error(fmt::format("command {} has no function", name));
}

int run_dapple(const std::vector<std::string>& words) {
  const auto result = call_guarded([&] { return run_words(words); });
  if (result) return *result;
  report("dapple", result.error());
  return static_cast<int>(result.error().code);
}

}  // namespace dapple
