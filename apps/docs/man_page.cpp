#include <fmt/format.h>

#include <algorithm>

#include "docs/documents.h"

namespace dapple {
namespace {

// Plain text in roff: hyphens that can be copied, and no line that looks like a request.
std::string roff(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  const bool looks_like_request = !result.empty() && (result[0] == '.' || result[0] == '\'');
  return looks_like_request ? "\\&" + result : result;
}

class Page {
 public:
  void section(std::string_view title) { text_ += fmt::format(".SH {}\n", title); }
  void line(std::string_view text) { text_ += fmt::format("{}\n", roff(text)); }
  // A term, which is roff already, with its explanation indented below it.
  void item(std::string_view term, std::string_view explanation) {
    text_ += fmt::format(".TP\n{}\n{}\n", term, roff(explanation));
  }
  void request(std::string_view text) { text_ += fmt::format("{}\n", text); }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string option_term(const OptionInfo& option) {
  std::string term;
  if (option.letter != 0) term = fmt::format("\\fB\\-{}\\fR, ", option.letter);
  term += fmt::format("\\fB\\-\\-{}\\fR", roff(option.name));
  const std::string value = value_text(option);
  if (value.empty()) return term;
  // Choices are typed as they stand, other values are stood for by their names.
  const char font = option.kind == ValueKind::choice ? 'R' : 'I';
  return term + fmt::format("=\\f{}{}\\fR", font, roff(value));
}

void add_synopsis(const CommandInfo& command, Page& page) {
  page.section("SYNOPSIS");
  const std::string text = synopsis(command);
  page.request(fmt::format("\\fB{}\\fR{}", roff(command.name),
                           roff(std::string_view(text).substr(command.name.size()))));
}

void add_lists(const CommandInfo& command, Page& page) {
  if (!command.arguments.empty()) page.section("ARGUMENTS");
  for (const OptionInfo& argument : command.arguments) {
    page.item(fmt::format("\\fI{}\\fR", argument.name), help_text(argument) + ".");
  }
  if (!command.commands.empty()) page.section("COMMANDS");
  for (const CommandInfo& each : command.commands) {
    page.item(fmt::format("\\fB{}\\fR(1)", roff(page_name(each.name))),
              fmt::format("{}.", each.summary));
  }
  if (!command.options.empty()) page.section("OPTIONS");
  for (const OptionInfo& option : command.options) {
    page.item(option_term(option), help_text(option) + ".");
  }
}

void add_exit_codes(const CommandInfo& command, Page& page) {
  page.section("EXIT STATUS");
  for (const ExitCode& exit_code : command.exit_codes) {
    page.item(fmt::format("\\fB{}\\fR", exit_code.code), exit_code.meaning);
  }
}

void add_environment(Page& page) {
  page.section("ENVIRONMENT");
  page.item("\\fBOMP_NUM_THREADS\\fR",
            "How many threads to use; the other variables of OpenMP count too.");
  page.item("\\fBDAPPLE_ISA\\fR",
            "The instruction set to use instead of the best one that the processor has; --version "
            "lists them. The results are the same, bit for bit.");
}

void add_examples(const CommandInfo& command, Page& page) {
  page.section("EXAMPLES");
  for (const Example& example : command.examples) {
    page.item(fmt::format("\\fB{}\\fR", roff(example.command)), example.meaning);
  }
}

void add_see_also(const CommandInfo& command, Page& page) {
  page.section("SEE ALSO");
  std::string text;
  const auto add = [&](std::string_view name) {
    if (name == command.name) return;
    text += fmt::format("{}\\fB{}\\fR(1)", text.empty() ? "" : ", ", roff(page_name(name)));
  };
  add(dapple_program().name);
  for (const CommandInfo& each : dapple_program().commands) add(each.name);
  for (const CommandInfo& each : classic_programs()) add(each.name);
  page.request(text);
}

}  // namespace

std::string man_page(const CommandInfo& command, std::string_view version) {
  Page page;
  std::string title = page_name(command.name);
  std::transform(title.begin(), title.end(), title.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  page.request(fmt::format(".TH {} 1 \"\" \"dapple {}\" \"User Commands\"", title, version));
  page.section("NAME");
  page.line(fmt::format("{} - {}", page_name(command.name), command.summary));
  add_synopsis(command, page);
  page.section("DESCRIPTION");
  for (const std::string_view paragraph : command.paragraphs) {
    page.request(".PP");
    page.line(paragraph);
  }
  add_lists(command, page);
  add_exit_codes(command, page);
  add_environment(page);
  add_examples(command, page);
  add_see_also(command, page);
  return page.take();
}

}  // namespace dapple
