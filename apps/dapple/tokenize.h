// A command line cut into options with their values and the words that remain.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/command_table.h"
#include "util/error.h"

namespace dapple {

struct Tokens {
  // By long name, in the order given; a flag has one empty value for each time.
  std::map<std::string, std::vector<std::string>, std::less<>> options;
  std::vector<std::string> arguments;
  std::vector<std::string> unknown;  // options that the table does not have
};

// GNU conventions: options and arguments in any order, --name=value or --name value, -n value or
// -nvalue, flags bundled as -ab, and nothing after "--" is an option.
[[nodiscard]] Expected<Tokens> tokenize(const CommandInfo& command,
                                        const std::vector<std::string>& words);

}  // namespace dapple
