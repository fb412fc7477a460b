#include "import/text.h"

#include <fmt/format.h>
#include <algorithm>

#include <charconv>
#include <cmath>
#include <limits>

namespace dapple {

std::string line_place(std::string_view file, std::size_t line) {
  return fmt::format("{}:{}", file, line);
}

std::string byte_place(std::string_view file, std::size_t offset) {
  return fmt::format("{}, byte {}", file, offset);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::optional<double> to_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  double value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (stop != word.data() + word.size() || error == std::errc::invalid_argument) {
    return std::nullopt;
  }
  if (error == std::errc::result_out_of_range) {
    // from_chars does not say on which side; a number this small carries a negative exponent or
    // hundreds of zeros behind its point.
    const std::size_t e = word.find_first_of("eE");
    const bool small = e == word.npos ? word.find_first_not_of("-0") == word.find('.')
                                      : word.substr(e + 1).starts_with('-');
    if (small) return 0.0;
    const double infinity = std::numeric_limits<double>::infinity();
    return word.starts_with('-') ? -infinity : infinity;
  }
  return value;
}

std::optional<std::int64_t> to_integer(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (stop != word.data() + word.size() || error != std::errc()) return std::nullopt;
  return value;
}

float to_float(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (value > kLargest) return kInfinity;
  if (value < -kLargest) return -kInfinity;
  return static_cast<float>(value);
}

bool LineReader::next(std::string_view& line) {
  if (position_ >= text_.size()) return false;
  const std::size_t start = position_;
  const std::size_t end = std::min(text_.find_first_of("\r\n", start), text_.size());
  line = text_.substr(start, end - start);
  position_ = end + 1;
  if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++position_;
  ++number_;
  return true;
}

std::string_view WordReader::next() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  std::size_t length = 0;
  while (length < rest_.size() && !is_blank(rest_[length])) ++length;
  const std::string_view word = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return word;
}

}  // namespace dapple
