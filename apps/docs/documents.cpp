#include "docs/documents.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/named_scenes.h"

namespace dapple {
std::string page_name(std::string_view command) {
  std::string name(command);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::vector<Document> make_documents(std::string_view version) {
  std::vector<Document> documents;
  const auto add_page = [&](const CommandInfo& command) {
    documents.push_back(
        {fmt::format("man/{}.1", page_name(command.name)), man_page(command, version)});
  };
  const CommandInfo& program = dapple_program();
  add_page(program);
  for (const CommandInfo& command : program.commands) add_page(command);
  for (const CommandInfo& classic : classic_programs()) add_page(classic);
  documents.push_back({"completions/dapple.bash", bash_completion(program)});
  documents.push_back({"completions/dapple.fish", fish_completion(program)});
  documents.push_back({"completions/_dapple", zsh_completion(program)});
  return documents;
}

std::string value_words(const OptionInfo& option) {
  if (option.kind != ValueKind::scene) return fmt::format("{}", fmt::join(option.choices, " "));
  std::vector<std::string_view> names;
  for (const NamedScene& scene : named_scenes()) names.push_back(scene.name);
  return fmt::format("{}", fmt::join(names, " "));
}

bool takes_file(const OptionInfo& option) {
  return option.kind == ValueKind::input_file || option.kind == ValueKind::output_file ||
         option.kind == ValueKind::scene;
}

std::string escape(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace dapple
