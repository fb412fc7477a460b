#include "util/parse_number.h"

#include <fmt/format.h>

#include <charconv>

namespace dapple {

Expected<std::int64_t> parse_integer(std::string_view text, std::string_view name, std::int64_t low,
                                     std::int64_t high) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool whole = stop == end && error != std::errc::invalid_argument && !text.empty();
  if (!whole || error == std::errc::result_out_of_range || value < low || value > high) {
    return fail(Errc::usage, std::string(name),
                fmt::format("'{}' is not an integer from {} to {}", text, low, high));
  }
  return value;
}

}  // namespace dapple
