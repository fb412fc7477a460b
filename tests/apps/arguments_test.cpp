// Every option of every table is read as the table says.
#include "dapple/arguments.h"

#include <gtest/gtest.h>

#include "dapple/nearest_name.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;

// A value that the table allows, other than the default where there is a choice.
std::string good_value(const OptionInfo& option) {
  switch (option.kind) {
    case ValueKind::integer:
      return std::to_string(option.high);
    case ValueKind::integers:
      return std::to_string(option.high) + "," + std::to_string(option.low);
    case ValueKind::number:
      return "0.25";
    case ValueKind::real:
      return "-0.25";
    case ValueKind::triple:
      return "1,-2.5,3";
    case ValueKind::choice:
      return std::string(option.choices.back());
    default:
      return "a name";
  }
}

std::vector<std::string> bad_values(const OptionInfo& option) {
  switch (option.kind) {
    case ValueKind::integer:
      return {
          "x",   "12x", "1e3", "+5", " 5", "1.5", "99999999999999999999", "-9223372036854775808",
          "0x10"};
    case ValueKind::integers:
      return {"x", "1,", ",1", "1,,2", "1, 2", "1;2", "1,x", std::to_string(option.high + 1)};
    case ValueKind::number:
      return {"x", "-1", "nan", "inf", "1,5", " 1", "-0", "1e999"};
    case ValueKind::real:
      return {"x", "nan", "inf", "1,5", " 1", "1e999"};
    case ValueKind::triple:
      return {"x", "1,2", "1,2,3,4", "1,2,nan", "1,,3", "1, 2, 3"};
    case ValueKind::choice:
      return {"no-such-choice", "LINEAR", " "};
    default:
      return {};
  }
}

// What the command needs at least, without the option of that name.
Words required_words(const CommandInfo& command, std::string_view without) {
  Words words;
  for (const OptionInfo& argument : command.arguments) {
    if (argument.required) words.push_back("argument");
  }
  for (const OptionInfo& option : command.options) {
    if (!option.required || option.name == without) continue;
    words.push_back("--" + std::string(option.name));
    words.push_back(good_value(option));
  }
  return words;
}

// Every way of typing an option with its value.
std::vector<Words> spellings(const OptionInfo& option, const std::string& value) {
  const std::string name = "--" + std::string(option.name);
  const std::string letter = std::string("-") + option.letter;
  if (option.kind == ValueKind::flag) {
    return option.letter == 0 ? std::vector<Words>{{name}} : std::vector<Words>{{name}, {letter}};
  }
  std::vector<Words> all = {{name, value}, {name + "=" + value}};
  if (option.letter != 0) {
    all.push_back({letter, value});
    all.push_back({letter + value});
  }
  return all;
}

std::vector<const CommandInfo*> all_commands() {
  std::vector<const CommandInfo*> all = {&dapple_program()};
  for (const CommandInfo& command : dapple_program().commands) all.push_back(&command);
  return all;
}

template <class Visit>
void for_each_option(Visit&& visit) {
  for (const CommandInfo* command : all_commands()) {
    for (const OptionInfo& option : command->options) {
      SCOPED_TRACE(std::string(command->name) + " --" + std::string(option.name));
      visit(*command, option);
    }
  }
}

TEST(Arguments, EveryOptionIsReadInEverySpellingAndPlace) {
  for_each_option([](const CommandInfo& command, const OptionInfo& option) {
    const std::string value = good_value(option);
    for (const Words& spelling : spellings(option, value)) {
      const Words rest = required_words(command, option.name);
      for (std::size_t place = 0; place <= rest.size(); ++place) {
        // Not between another option and its value.
        if (place > 0 && rest[place - 1].starts_with("--")) continue;
        Words words = rest;
        words.insert(words.begin() + static_cast<std::ptrdiff_t>(place), spelling.begin(),
                     spelling.end());
        const auto arguments = read_arguments(command, words);
        ASSERT_TRUE(arguments) << to_string(arguments.error());
        EXPECT_TRUE(arguments->given(option.name));
        if (option.kind != ValueKind::flag) {
          EXPECT_EQ(arguments->text(option.name), value);
        }
      }
    }
  });
}

TEST(Arguments, DefaultsAreValuesThatTheTableAllows) {
  for_each_option([](const CommandInfo& command, const OptionInfo& option) {
    if (option.default_value.empty()) return;
    Words words = required_words(command, option.name);
    words.push_back("--" + std::string(option.name) + "=" + option.default_value);
    const auto given = read_arguments(command, words);
    ASSERT_TRUE(given) << to_string(given.error());
    const auto left_out = read_arguments(command, required_words(command, option.name));
    ASSERT_TRUE(left_out);
    EXPECT_FALSE(left_out->given(option.name));
    EXPECT_EQ(left_out->text(option.name), given->text(option.name));
  });
}

TEST(Arguments, WrongValuesAreUsageErrorsThatNameTheOption) {
  for_each_option([](const CommandInfo& command, const OptionInfo& option) {
    std::vector<std::string> bad = bad_values(option);
    if (option.kind == ValueKind::integer) {
      bad.push_back(std::to_string(option.low - 1));
      if (option.high < INT64_MAX) bad.push_back(std::to_string(option.high + 1));
    }
    for (const std::string& value : bad) {
      Words words = required_words(command, option.name);
      words.push_back("--" + std::string(option.name));
      words.push_back(value);
      const auto arguments = read_arguments(command, words);
      ASSERT_FALSE(arguments) << value;
      EXPECT_EQ(arguments.error().code, Errc::usage);
      EXPECT_EQ(arguments.error().place, "--" + std::string(option.name));
    }
  });
}

TEST(Arguments, AMissingValueOrOneTooManyIsAnError) {
  for_each_option([](const CommandInfo& command, const OptionInfo& option) {
    const std::string name = "--" + std::string(option.name);
    Words words = required_words(command, option.name);
    words.push_back(option.kind == ValueKind::flag ? name + "=yes" : name);
    const auto arguments = read_arguments(command, words);
    ASSERT_FALSE(arguments);
    EXPECT_EQ(arguments.error().code, Errc::usage);
    words.back() = name + "=";
    EXPECT_FALSE(read_arguments(command, words));
  });
}

TEST(Arguments, RequiredOnesAreRequiredUnlessHelpIsAskedFor) {
  for (const CommandInfo* command : all_commands()) {
    const auto none = read_arguments(*command, {});
    EXPECT_EQ(none.has_value(), required_words(*command, "").empty()) << command->name;
    EXPECT_TRUE(read_arguments(*command, {"--help"})) << command->name;
  }
}

TEST(Arguments, ANearOptionIsNamed) {
  const auto& render = **find_command(dapple_program(), "render");
  const auto result = read_arguments(render, {"nice", "--widht", "3", "-o", "x"});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Errc::usage);
  EXPECT_EQ(result.error().place, "--widht");
  EXPECT_NE(result.error().message.find("--width"), std::string::npos);
}

TEST(Arguments, NothingAfterTwoDashesIsAnOption) {
  const auto& info = **find_command(dapple_program(), "info");
  const auto result = read_arguments(info, {"--", "--json"});
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->given("json"));
  EXPECT_EQ(result->text("SCENE"), "--json");
  EXPECT_FALSE(read_arguments(info, {"--", "a", "-b"}));
}

TEST(Arguments, NamesAreTakenAsTheyAre) {
  const auto& info = **find_command(dapple_program(), "info");
  for (const std::string name :
       {"[a,b]", "a b", "'a'", "\"a\"", "a=b", "{}", "-", "\xff\xfe", "@x"}) {
    const auto result = read_arguments(info, {name});
    ASSERT_TRUE(result) << name;
    EXPECT_EQ(result->text("SCENE"), name);
  }
}

TEST(Arguments, TheLastValueCountsUnlessAllDo) {
  const auto& render = **find_command(dapple_program(), "render");
  const auto one = read_arguments(render, {"nice", "-ox", "--spp", "3", "-s4"});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->integer("spp"), 4);
  const auto& bench = **find_command(dapple_program(), "bench");
  const auto all = read_arguments(bench, {"-afast", "nice", "--accel=linear"});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->texts("accel"), (Words{"fast", "linear"}));
}

TEST(Arguments, ShortFlagsMayBeBundled) {
  const auto& render = **find_command(dapple_program(), "render");
  const auto result = read_arguments(render, {"nice", "-qj3", "-ox"});
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->given("quiet"));
  EXPECT_EQ(result->integer("threads"), 3);
}

TEST(NearestName, FindsTheFewestEdits) {
  const std::vector<std::string> names = {"--width", "--height", "--help"};
  EXPECT_EQ(nearest_name("--widht", names), "--width");
  EXPECT_EQ(nearest_name("--hlep", names), "--help");
  EXPECT_EQ(nearest_name("--heigt", names), "--height");
  for (const std::string& name : names) EXPECT_EQ(nearest_name(name, names), name);
  EXPECT_EQ(nearest_name("xyz", {"abcdefgh"}), std::nullopt);
  EXPECT_EQ(nearest_name("", {}), std::nullopt);
}

}  // namespace
}  // namespace dapple
