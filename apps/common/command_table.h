// What the programs take on their command lines, as data. The parser, --help, the man pages and
// the shell completions are all made from these tables.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

enum class ValueKind {
  flag,         // no value: given or not
  integer,      // a decimal integer in [low, high]
  integers,     // such integers, separated by commas
  number,       // a decimal number, at least 0
  real,         // a decimal number, of any sign
  triple,       // three of those with commas between
  text,         // anything but nothing
  choice,       // one of `choices`
  input_file,   // an existing file
  output_file,  // a file to write
  scene,        // a scene's name or a scene file
};

// An option, or an argument that is told by its place.
struct OptionInfo {
  std::string_view name;  // long name without the dashes; an argument's name is in capitals
  char letter = 0;        // short name, 0 for none
  ValueKind kind = ValueKind::flag;
  std::string_view value = {};     // what help calls the value: N, FILE; empty for flag and choice
  std::string_view help = {};      // one sentence without its full stop
  std::string default_value = {};  // as it would be given; empty for none
  std::int64_t low = 0, high = 0;
  std::vector<std::string_view> choices = {};
  bool required = false;
  bool repeatable = false;  // all values count, not only the last
};

struct Example {
  std::string_view command;
  std::string_view meaning;
};

struct ExitCode {
  int code;
  std::string_view meaning;
};

// A program, or a subcommand of `dapple`.
struct CommandInfo {
  std::string_view name;                          // what is typed: "ray", "dapple render"
  std::string_view summary;                       // one line, lower case, without full stop
  std::vector<std::string_view> paragraphs = {};  // what it does, at length
  std::vector<OptionInfo> arguments = {};         // told by their places
  std::vector<OptionInfo> options = {};
  std::vector<Example> examples = {};
  std::vector<ExitCode> exit_codes = {};
  std::vector<CommandInfo> commands = {};  // subcommands, in alphabetical order
};

// `dapple` itself: its own options stand before a subcommand.
[[nodiscard]] const CommandInfo& dapple_program();
// ray, ray_bvh, store_scene and describe_scene.
[[nodiscard]] const std::vector<CommandInfo>& classic_programs();
[[nodiscard]] const CommandInfo& classic_program(std::string_view name);

// "dapple render [OPTION]... SCENE -o FILE": options that are not required in brackets.
[[nodiscard]] std::string synopsis(const CommandInfo& command);
// The last word of the name: "render" of "dapple render".
[[nodiscard]] std::string_view last_word(std::string_view name);
// "N", "FILE", "linear|median|fast"; empty for a flag.
[[nodiscard]] std::string value_text(const OptionInfo& option);
// The help sentence with range and default: "Width in pixels (1 to 1048576; default 800)".
[[nodiscard]] std::string help_text(const OptionInfo& option);

}  // namespace dapple
