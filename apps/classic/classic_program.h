// What the four classic programs share.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "accel/accel.h"
#include "util/error.h"

namespace dapple {

struct ClassicArguments {
  std::vector<std::string> values;           // as many as the program's table allows
  std::set<std::string, std::less<>> flags;  // names without their dashes
};

using ClassicBody = std::function<Status(const ClassicArguments& arguments)>;

// Runs the program `name` of classic_programs(): 0 when the body succeeds, 2 and a usage line for
// a wrong command line, 1 for any other failure. `--help` and `--version` are answered here.
int run_classic_program(std::string_view name, int argc, char** argv, const ClassicBody& body);

// The bodies. The times that they take go to standard output.
[[nodiscard]] Status classic_render(const ClassicArguments& arguments, AccelKind kind);
[[nodiscard]] Status classic_store(const ClassicArguments& arguments);
[[nodiscard]] Status classic_describe(const ClassicArguments& arguments);

}  // namespace dapple
