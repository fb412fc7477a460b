#include "classic/classic_program.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/command_table.h"
#include "common/help.h"
#include "common/program.h"
#include "common/standard_output.h"
#include "common/version.h"

namespace dapple {
namespace {

constexpr int kFailure = 1;
constexpr int kWrongUsage = 2;

bool has_option(const CommandInfo& program, std::string_view name) {
  return std::any_of(program.options.begin(), program.options.end(),
                     [&](const OptionInfo& option) { return option.name == name; });
}

// Options may stand anywhere before "--". A single dash begins no option, so that a negative
// number gets its own message.
Expected<ClassicArguments> parse(const CommandInfo& program, int argc, char** argv) {
  ClassicArguments result;
  bool options_end = false;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    if (options_end || !text.starts_with("--")) {
      result.values.push_back(text);
    } else if (text == "--") {
      options_end = true;
    } else if (has_option(program, text.substr(2))) {
      result.flags.insert(text.substr(2));
    } else {
      return fail(Errc::usage, text, "unknown option");
    }
  }
  const auto& arguments = program.arguments;
  const std::size_t given = result.values.size();
  if (given > arguments.size()) {
    return fail(Errc::usage, result.values[arguments.size()], "one argument too many");
  }
  if (given < arguments.size() && arguments[given].required) {
    return fail(Errc::usage, std::string(arguments[given].name), "this argument is missing");
  }
  return result;
}

int answer(std::string_view text, const CommandInfo& program) {
  const Status printed = print_output(text);
  if (printed) return 0;
  report(program.name, printed.error());
  return kFailure;
}

}  // namespace

int run_classic_program(std::string_view name, int argc, char** argv, const ClassicBody& body) {
  prepare_process(kFailure);
  const CommandInfo& program = classic_program(name);
  const std::string_view only = argc == 2 ? argv[1] : "";
  if (only == "--help") return answer(help_page(program), program);
  if (only == "--version") return answer(version_text(name), program);

  const auto result = call_guarded([&]() -> Expected<int> {
    const auto arguments = parse(program, argc, argv);
    if (!arguments) return tl::unexpected(arguments.error());
    return body(*arguments).map([] { return 0; });
  });
  if (result) return *result;
  report(name, result.error());
  if (result.error().code != Errc::usage) return kFailure;
  print_message(fmt::format("usage: {}\n", synopsis(program)));
  return kWrongUsage;
}

}  // namespace dapple
