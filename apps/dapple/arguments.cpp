#include "dapple/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "dapple/nearest_name.h"
#include "dapple/tokenize.h"
#include "util/parse_number.h"

namespace dapple {
namespace {

const OptionInfo& info_of(const CommandInfo& command, std::string_view name) {
  for (const auto* list : {&command.options, &command.arguments}) {
    const auto found = std::find_if(list->begin(), list->end(),
                                    [&](const OptionInfo& info) { return info.name == name; });
    if (found != list->end()) return *found;
  }
  throw std::logic_error(fmt::format("{} has no option {}", command.name, name));
}

// The option as errors name it.
std::string place_of(const OptionInfo& info) {
  const bool is_argument = !info.name.empty() && info.name[0] >= 'A' && info.name[0] <= 'Z';
  return is_argument ? std::string(info.name) : fmt::format("--{}", info.name);
}

Expected<double> parse_real(std::string_view text, const std::string& name) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    return fail(Errc::usage, name, fmt::format("'{}' is not a number", text));
  }
  return value;
}

Expected<double> parse_number(const std::string& text, const std::string& name) {
  const auto value = parse_real(text, name);
  if (!value || std::signbit(*value)) {
    return fail(Errc::usage, name, fmt::format("'{}' is not a number from 0 on", text));
  }
  return value;
}

Expected<std::array<double, 3>> parse_triple(std::string_view text, const std::string& name) {
  const auto wrong =
      fail(Errc::usage, name, fmt::format("'{}' is not three numbers with commas between", text));
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == text.npos) != (i == 2)) return wrong;
    const auto value = parse_real(text.substr(0, comma), name);
    if (!value) return wrong;
    values[i] = *value;
    if (i < 2) text.remove_prefix(comma + 1);
  }
  return values;
}

Expected<std::vector<int>> parse_integers(const std::string& text, const OptionInfo& info) {
  std::vector<int> values;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto value = parse_integer(std::string_view(text).substr(begin, end - begin),
                                     place_of(info), info.low, info.high);
    if (!value) return tl::unexpected(value.error());
    values.push_back(static_cast<int>(*value));
    begin = end + 1;
  }
  return values;
}

Status check_choice(const OptionInfo& info, const std::string& value) {
  const auto& choices = info.choices;
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return {};
  return fail(Errc::usage, place_of(info),
              fmt::format("'{}' is not one of {}", value, fmt::join(choices, ", ")));
}

Status check_value(const OptionInfo& info, const std::string& value) {
  const auto drop_value = [](const auto&) {};
  switch (info.kind) {
    case ValueKind::integer:
      return parse_integer(value, place_of(info), info.low, info.high).map(drop_value);
    case ValueKind::integers:
      return parse_integers(value, info).map(drop_value);
    case ValueKind::number:
      return parse_number(value, place_of(info)).map(drop_value);
    case ValueKind::real:
      return parse_real(value, place_of(info)).map(drop_value);
    case ValueKind::triple:
      return parse_triple(value, place_of(info)).map(drop_value);
    case ValueKind::choice:
      return check_choice(info, value);
    case ValueKind::flag:
      return {};
    case ValueKind::input_file:
    case ValueKind::output_file:
    case ValueKind::scene:
    case ValueKind::text:
      break;
  }
  if (!value.empty()) return {};
  return fail(Errc::usage, place_of(info), "the name is empty");
}

tl::unexpected<Error> unknown_option(const CommandInfo& command, const std::string& word) {
  std::vector<std::string> names;
  for (const OptionInfo& option : command.options)
    names.push_back(fmt::format("--{}", option.name));
  const auto nearest = nearest_name(word.substr(0, word.find('=')), names);
  return fail(Errc::usage, word,
              "unknown option" + (nearest ? fmt::format("; did you mean {}?", *nearest) : ""));
}

}  // namespace

class ArgumentReader {
 public:
  explicit ArgumentReader(const CommandInfo& command) : command_(command), result_(command) {}

  Expected<Arguments> read(const std::vector<std::string>& words) {
    const auto tokens = tokenize(command_, words);
    if (!tokens) return tl::unexpected(tokens.error());
    if (!tokens->unknown.empty()) return unknown_option(command_, tokens->unknown[0]);
    result_.values_ = tokens->options;
    if (auto status = place(tokens->arguments); !status) return tl::unexpected(status.error());
    if (auto status = check(); !status) return tl::unexpected(status.error());
    return std::move(result_);
  }

 private:
  Status place(const std::vector<std::string>& values) {
    const auto& arguments = command_.arguments;
    if (values.size() > arguments.size()) {
      return fail(Errc::usage, values[arguments.size()], "one argument too many");
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      result_.values_[std::string(arguments[i].name)] = {values[i]};
    }
    return {};
  }

  Status check() const {
    for (const auto* list : {&command_.arguments, &command_.options}) {
      for (const OptionInfo& info : *list) {
        if (auto status = check(info); !status) return status;
      }
    }
    return {};
  }

  Status check(const OptionInfo& info) const {
    const auto found = result_.values_.find(info.name);
    if (found == result_.values_.end()) {
      if (!info.required || asks_for_help()) return {};
      return fail(Errc::usage, place_of(info), "it is missing; usage: " + synopsis(command_));
    }
    for (const std::string& value : found->second) {
      if (auto status = check_value(info, value); !status) return status;
    }
    return {};
  }

  bool asks_for_help() const {
    return result_.values_.contains("help") || result_.values_.contains("version");
  }

  const CommandInfo& command_;
  Arguments result_;
};

Expected<Arguments> read_arguments(const CommandInfo& command,
                                   const std::vector<std::string>& words) {
  return ArgumentReader(command).read(words);
}

bool Arguments::given(std::string_view name) const {
  info_of(*command_, name);
  return values_.contains(name);
}

std::vector<std::string> Arguments::texts(std::string_view name) const {
  const OptionInfo& info = info_of(*command_, name);
  const auto found = values_.find(name);
  if (found == values_.end()) return {info.default_value};
  return found->second;
}

std::string Arguments::text(std::string_view name) const { return texts(name).back(); }

std::int64_t Arguments::integer(std::string_view name) const {
  const OptionInfo& info = info_of(*command_, name);
  return parse_integer(text(name), name, info.low, info.high).value();
}

int Arguments::small_integer(std::string_view name) const {
  return static_cast<int>(integer(name));
}

std::vector<int> Arguments::integers(std::string_view name) const {
  return parse_integers(text(name), info_of(*command_, name)).value();
}

double Arguments::number(std::string_view name) const {
  return parse_number(text(name), std::string(name)).value();
}

double Arguments::real(std::string_view name) const {
  return parse_real(text(name), std::string(name)).value();
}

std::array<double, 3> Arguments::triple(std::string_view name) const {
  return parse_triple(text(name), std::string(name)).value();
}

Expected<const CommandInfo*> find_command(const CommandInfo& program, std::string_view name) {
  std::vector<std::string> names;
  for (const CommandInfo& command : program.commands) {
    if (last_word(command.name) == name) return &command;
    names.emplace_back(last_word(command.name));
  }
  const auto nearest = nearest_name(name, names);
  return fail(Errc::usage, std::string(name),
              fmt::format("unknown command{}; there are {}",
                          nearest ? fmt::format(" (did you mean {}?)", *nearest) : "",
                          fmt::join(names, ", ")));
}

}  // namespace dapple
