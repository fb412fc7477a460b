#include "tables/splice.h"

#include <fmt/format.h>

namespace dapple::bench {

Status splice(const std::string& name, const std::string& text, std::string& document) {
  const std::string begin = fmt::format("<!-- begin {} -->\n", name);
  const std::string end = fmt::format("<!-- end {} -->", name);
  const std::size_t at = document.find(begin);
  if (at == std::string::npos) return {};
  const std::size_t from = at + begin.size();
  const std::size_t to = document.find(end, from);
  if (to == std::string::npos) {
    return fail(Errc::bad_data, "", fmt::format("section '{}' has no end", name));
  }
  document.replace(from, to - from, fmt::format("\n{}\n", text));
  return {};
}

}  // namespace dapple::bench
