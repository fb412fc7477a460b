// Lines, words and numbers of text formats, and how errors name a place in a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dapple {

// "FILE:12" and "FILE, byte 12".
[[nodiscard]] std::string line_place(std::string_view file, std::size_t line);
[[nodiscard]] std::string byte_place(std::string_view file, std::size_t offset);

[[nodiscard]] inline std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f'; }

[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string in_lower_case(std::string_view text);

// The whole word must be the number. Too large is infinite, too small zero; "nan" and "inf" are
// numbers too, for the caller to refuse by name.
[[nodiscard]] std::optional<double> to_number(std::string_view word);
[[nodiscard]] std::optional<std::int64_t> to_integer(std::string_view word);

// Beyond the range of float: infinite.
[[nodiscard]] float to_float(double value);

// Lines without their ends, numbered from 1; "\n", "\r\n" and "\r" all end one.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : text_(text) {}

  [[nodiscard]] bool next(std::string_view& line);
  std::size_t number() const { return number_; }      // of the line last read
  std::size_t position() const { return position_; }  // where the next line begins

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t number_ = 0;
};

// Words of one line, separated by blanks.
class WordReader {
 public:
  explicit WordReader(std::string_view line) : rest_(line) {}

  std::string_view next();  // empty at the end
  std::string_view rest() const { return trimmed(rest_); }

 private:
  std::string_view rest_;
};

}  // namespace dapple
