// Man pages and shell completions, made from the tables of the command lines.
#pragma once

#include <string>
#include <vector>

#include "common/command_table.h"

namespace dapple {

struct Document {
  std::string path;  // below the build folder: "man/dapple.1"
  std::string text;
};

// All of them.
[[nodiscard]] std::vector<Document> make_documents(std::string_view version);

// "dapple render" is described in dapple-render(1).
[[nodiscard]] std::string page_name(std::string_view command);
// A page of section 1 in roff.
[[nodiscard]] std::string man_page(const CommandInfo& command, std::string_view version);

// Completions of a program with subcommands.
[[nodiscard]] std::string bash_completion(const CommandInfo& program);
[[nodiscard]] std::string fish_completion(const CommandInfo& program);
[[nodiscard]] std::string zsh_completion(const CommandInfo& program);

// What may be typed for a value, apart from files: choices or the names of scenes.
[[nodiscard]] std::string value_words(const OptionInfo& option);
[[nodiscard]] bool takes_file(const OptionInfo& option);

// `text` with a backslash before each of the characters.
[[nodiscard]] std::string escape(std::string_view text, std::string_view characters);

}  // namespace dapple
