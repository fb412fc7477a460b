#include "common/standard_output.h"

#include <cerrno>
#include <cstdio>

namespace dapple {

Status print_output(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return {};
  return fail(Errc::io, "standard output", "cannot write: " + errno_text(errno));
}

}  // namespace dapple
