// Help, man pages and completions offer exactly the options of the tables.
#include "docs/documents.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "common/help.h"
#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Names = std::set<std::string>;

std::string document(const std::string& path) {
  std::ifstream file(std::string(DAPPLE_DOCUMENT_FOLDER "/") + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// "--width" and, with letters, "-o" of every option.
Names table_names(const CommandInfo& command, bool with_letters) {
  Names names;
  for (const OptionInfo& option : command.options) {
    names.insert("--" + std::string(option.name));
    if (with_letters && option.letter != 0) names.insert(std::string("-") + option.letter);
  }
  return names;
}

// The first group of every match.
Names all_matches(const std::string& text, const std::string& pattern) {
  Names names;
  const std::regex regex(pattern);
  for (auto i = std::sregex_iterator(text.begin(), text.end(), regex); i != std::sregex_iterator();
       ++i) {
    names.insert((*i)[1].str());
  }
  return names;
}

// From `begin` to the next `end`, or to the end of the text.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  if (from == std::string::npos) return "";
  return text.substr(from, text.find(end, from + begin.size()) - from);
}

std::vector<const CommandInfo*> all_commands() {
  std::vector<const CommandInfo*> all = {&dapple_program()};
  for (const CommandInfo& command : dapple_program().commands) all.push_back(&command);
  for (const CommandInfo& program : classic_programs()) all.push_back(&program);
  return all;
}

TEST(Help, ListsExactlyTheOptions) {
  for (const CommandInfo* command : all_commands()) {
    const std::string options = between(help_page(*command), "\nOptions:\n", "\nExamples:\n");
    EXPECT_EQ(all_matches(options, "\n  (?:-., |    )(--[a-z-]+)"), table_names(*command, false))
        << command->name;
  }
}

TEST(Help, ListsArgumentsAndExamples) {
  for (const CommandInfo* command : all_commands()) {
    const std::string page = help_page(*command);
    EXPECT_TRUE(page.starts_with("usage: " + synopsis(*command) + "\n"));
    for (const OptionInfo& argument : command->arguments) {
      EXPECT_NE(page.find("\n  " + std::string(argument.name) + " "), std::string::npos);
    }
    for (const Example& example : command->examples) {
      EXPECT_NE(page.find("\n  " + std::string(example.command) + "\n"), std::string::npos);
    }
  }
}

TEST(Help, IsAtMost80ColumnsWide) {
  for (const CommandInfo* command : all_commands()) {
    std::istringstream page(help_page(*command));
    for (std::string line; std::getline(page, line);) EXPECT_LE(line.size(), 80u) << line;
  }
}

TEST(Wrap, KeepsTheWordsAndTheWidth) {
  const std::string text = "one two three four five six seven eight nine ten";
  for (std::size_t width = 1; width < 60; ++width) {
    std::string joined;
    std::istringstream lines(wrap(text, width, 0));
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(line.size() <= width || line.find(' ') == std::string::npos);
      joined += (joined.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(joined, text);
  }
}

TEST(ManPages, ListExactlyTheOptionsAndTheExitCodes) {
  for (const CommandInfo* command : all_commands()) {
    const std::string page = document("man/" + page_name(command->name) + ".1");
    ASSERT_FALSE(page.empty()) << command->name;
    const std::string options = between(page, ".SH OPTIONS\n", ".SH ");
    Names names;
    for (const std::string& name : all_matches(options, "fB\\\\-\\\\-([a-z\\\\-]+)\\\\fR")) {
      names.insert("--" + std::regex_replace(name, std::regex("\\\\-"), "-"));
    }
    EXPECT_EQ(names, table_names(*command, false)) << command->name;
    Names codes;
    for (const ExitCode& code : command->exit_codes) codes.insert(std::to_string(code.code));
    EXPECT_EQ(all_matches(between(page, ".SH EXIT STATUS\n", ".SH "), "\\\\fB([0-9]+)\\\\fR"),
              codes);
  }
}

TEST(Documents, AreWhatTheBuildWrote) {
  for (const Document& each : make_documents("")) {
    EXPECT_FALSE(each.text.empty());
    if (each.path.starts_with("completions/")) {
      EXPECT_EQ(document(each.path), each.text);
    }
  }
}

// What bash offers after these words.
Names bash_offers(const std::vector<std::string>& words) {
  const TestFolder folder;
  std::string script = ". '" DAPPLE_DOCUMENT_FOLDER "/completions/dapple.bash'\nCOMP_WORDS=(";
  for (const std::string& word : words) script += "'" + word + "' ";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
            "\n_dapple\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  const auto result = folder.run({"/bin/bash", "-c", script});
  EXPECT_EQ(result.err, "");
  std::istringstream lines(result.out);
  Names names;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) names.insert(line);
  }
  return names;
}

Names words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(BashCompletion, OffersExactlyTheOptions) {
  EXPECT_EQ(bash_offers({"dapple", "-"}), table_names(dapple_program(), true));
  for (const CommandInfo& command : dapple_program().commands) {
    const std::string name(last_word(command.name));
    EXPECT_EQ(bash_offers({"dapple", name, "-"}), table_names(command, true)) << name;
    EXPECT_EQ(bash_offers({"dapple", name, "--"}), table_names(command, false)) << name;
  }
}

TEST(BashCompletion, OffersCommandsAndValues) {
  Names commands;
  for (const CommandInfo& command : dapple_program().commands) {
    const std::string name(last_word(command.name));
    commands.insert(name);
    for (const OptionInfo& option : command.options) {
      if (option.kind == ValueKind::flag) continue;
      const std::string typed = "--" + std::string(option.name);
      const Names expected = words_of(value_words(option));  // the folder is empty: no files
      EXPECT_EQ(bash_offers({"dapple", name, typed, ""}), expected);
      EXPECT_EQ(bash_offers({"dapple", name, typed, "="}), expected);
    }
  }
  EXPECT_EQ(bash_offers({"dapple", ""}), commands);
  EXPECT_EQ(bash_offers({"dapple", "info", "n"}), (Names{"nice"}));
}

TEST(FishCompletion, OffersExactlyTheOptions) {
  const std::string script = document("completions/dapple.fish");
  for (const CommandInfo& command : dapple_program().commands) {
    const std::string start =
        "__fish_seen_subcommand_from " + std::string(last_word(command.name)) + "'";
    Names names;
    std::istringstream lines(script);
    for (std::string line; std::getline(lines, line);) {
      if (line.find(start) == std::string::npos) continue;
      for (const std::string& name : all_matches(line, " -l ([a-z-]+)")) names.insert("--" + name);
      for (const std::string& name : all_matches(line, " -s ([a-zA-Z])")) names.insert("-" + name);
    }
    EXPECT_EQ(names, table_names(command, true)) << command.name;
  }
}

TEST(ZshCompletion, OffersExactlyTheOptions) {
  const std::string script = document("completions/_dapple");
  for (const CommandInfo& command : dapple_program().commands) {
    const std::string name(last_word(command.name));
    const std::string part = between(script, "        " + name + ")\n", ";;");
    EXPECT_EQ(all_matches(part, "[{,'*](--?[a-zA-Z][a-z-]*)(?=[=+,\\[}])"),
              table_names(command, true))
        << name;
  }
}

}  // namespace
}  // namespace dapple
