// The tables of the command lines make sense in themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "accel/accel.h"
#include "dapple/commands.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;

std::vector<const CommandInfo*> all_commands() {
  std::vector<const CommandInfo*> all = {&dapple_program()};
  for (const CommandInfo& command : dapple_program().commands) all.push_back(&command);
  return all;
}

TEST(Tables, NamesAndLettersAreUnique) {
  for (const CommandInfo* command : all_commands()) {
    std::set<std::string_view> names;
    std::set<char> letters;
    for (const OptionInfo& option : command->options) {
      EXPECT_TRUE(names.insert(option.name).second) << command->name << ' ' << option.name;
      EXPECT_TRUE(option.letter == 0 || letters.insert(option.letter).second)
          << command->name << ' ' << option.letter;
      EXPECT_FALSE(option.help.empty());
    }
  }
}

TEST(Tables, EveryCommandHasAFunctionAndTheyAreInOrder) {
  std::string last;
  for (const CommandInfo& command : dapple_program().commands) {
    const std::string name(last_word(command.name));
    EXPECT_LT(last, name);
    last = name;
    EXPECT_NE(command_function(name), nullptr);
    EXPECT_EQ(*find_command(dapple_program(), name), &command);
  }
  EXPECT_THROW(static_cast<void>(command_function("no-such-command")), std::logic_error);
}

TEST(Tables, AccelChoicesAreTheAccels) {
  for (const CommandInfo* command : all_commands()) {
    for (const OptionInfo& option : command->options) {
      if (option.name != "accel") continue;
      for (const std::string_view choice : option.choices) EXPECT_TRUE(parse_accel_kind(choice));
      EXPECT_EQ(option.choices.size(), 3u);
    }
  }
}

TEST(Tables, QualityChoicesAreTheQualities) {
  for (const CommandInfo* command : all_commands()) {
    for (const OptionInfo& option : command->options) {
      if (option.name != "bvh-quality") continue;
      for (const std::string_view choice : option.choices) EXPECT_TRUE(parse_bvh_quality(choice));
      EXPECT_EQ(option.choices.size(), kBvhQualityNames.size());
    }
  }
}

// "NAME=value dapple render nice -o x.png | other": the words after the command's name.
Words example_words(const CommandInfo& command, const Example& example) {
  std::istringstream stream{std::string(example.command)};
  Words words;
  for (std::string word; stream >> word && word != "|";) {
    if (words.empty() && word.find('=') != std::string::npos) continue;
    words.push_back(word);
  }
  std::istringstream name{std::string(command.name)};
  for (std::string word; name >> word;) {
    EXPECT_EQ(words.at(0), word) << example.command;
    words.erase(words.begin());
  }
  return words;
}

TEST(Tables, ExamplesAreValidCommandLines) {
  for (const CommandInfo& command : dapple_program().commands) {
    EXPECT_FALSE(command.examples.empty()) << command.name;
    for (const Example& example : command.examples) {
      const auto result = read_arguments(command, example_words(command, example));
      EXPECT_TRUE(result) << example.command;
    }
  }
  for (const Example& example : dapple_program().examples) {
    const Words words = example_words(dapple_program(), example);
    EXPECT_TRUE(find_command(dapple_program(), words.at(0))) << example.command;
  }
  for (const CommandInfo& program : classic_programs()) {
    for (const Example& example : program.examples) {
      const Words words = example_words(program, example);
      const auto values = static_cast<std::size_t>(std::count_if(
          words.begin(), words.end(), [](const auto& word) { return !word.starts_with("--"); }));
      EXPECT_LE(values, program.arguments.size()) << example.command;
    }
  }
}

TEST(Tables, EveryErrorHasItsExitCode) {
  for (const CommandInfo* command : all_commands()) {
    std::set<int> codes;
    for (const ExitCode& exit_code : command->exit_codes) codes.insert(exit_code.code);
    for (const Errc code : {Errc::usage, Errc::bad_data, Errc::no_input, Errc::internal,
                            Errc::memory, Errc::cannot_create, Errc::io}) {
      EXPECT_TRUE(codes.contains(static_cast<int>(code))) << command->name;
    }
    EXPECT_TRUE(codes.contains(0));
  }
}

}  // namespace
}  // namespace dapple
