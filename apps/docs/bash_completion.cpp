#include <fmt/format.h>

#include "docs/documents.h"

namespace dapple {
namespace {

std::string names_pattern(const OptionInfo& option) {
  if (option.letter == 0) return fmt::format("--{}", option.name);
  return fmt::format("-{}|--{}", option.letter, option.name);
}

// Every way of typing every option.
std::string option_words(const CommandInfo& command) {
  std::string words;
  for (const OptionInfo& option : command.options) {
    if (option.letter != 0) words += fmt::format("-{} ", option.letter);
    words += fmt::format("--{} ", option.name);
  }
  if (!words.empty()) words.pop_back();
  return words;
}

// What may stand where an argument stands, as the two variables of the script.
std::string operands(const CommandInfo& command) {
  std::string words;
  bool files = false;
  for (const OptionInfo& argument : command.arguments) {
    if (words.empty()) words = value_words(argument);
    files = files || takes_file(argument);
  }
  return fmt::format("        words='{}' files={}\n", words, files ? "yes" : "");
}

std::string command_case(const CommandInfo& command) {
  std::string text = fmt::format("    {})\n        options='{}'\n", last_word(command.name),
                                 option_words(command));
  text += operands(command);
  text += "        case $prev in\n";
  for (const OptionInfo& option : command.options) {
    if (option.kind == ValueKind::flag) continue;
    text += fmt::format("        {}) options='' words='{}' files={} ;;\n", names_pattern(option),
                        value_words(option), takes_file(option) ? "yes" : "");
  }
  return text + "        esac\n        ;;\n";
}

}  // namespace

std::string bash_completion(const CommandInfo& program) {
  std::string names;
  for (const CommandInfo& command : program.commands) {
    names += fmt::format("{}{}", names.empty() ? "" : " ", last_word(command.name));
  }
  std::string text = fmt::format(R"(# bash completion for {0}
_{0}() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}}
    local command='' options='' words='' files='' i
    # "--name=value" arrives as three words.
    if [[ $cur == '=' ]]; then
        cur=''
    elif [[ $prev == '=' ]]; then
        prev=${{COMP_WORDS[COMP_CWORD-2]}}
    fi
    for ((i = 1; i < COMP_CWORD; i++)); do
        if [[ ${{COMP_WORDS[i]}} != -* ]]; then
            command=${{COMP_WORDS[i]}}
            break
        fi
    done
    case $command in
    '')
        options='{1}' words='{2}'
        ;;
)",
                                 program.name, option_words(program), names);
  for (const CommandInfo& command : program.commands) text += command_case(command);
  text += fmt::format(R"(    esac
    [[ $cur == -* ]] && words=$options
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
    if [[ -n $files && $cur != -* ]]; then
        local -a names
        mapfile -t names < <(compgen -f -- "$cur")
        COMPREPLY+=("${{names[@]}}")
        compopt -o filenames 2>/dev/null
    fi
}}
complete -F _{0} {0}
)",
                      program.name);
  return text;
}

}  // namespace dapple
