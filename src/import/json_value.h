// A parsed JSON text. Reading never fails: what is absent or of another kind reads as the null
// value or as the default that is asked for, so only a check of its own has to look at kinds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "util/error.h"

namespace dapple {

struct JsonMember;

class JsonValue {
 public:
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;  // in the order of the text; keys are unique

  JsonValue() = default;
  template <class T>
  explicit JsonValue(T value) : value_(std::move(value)) {}

  bool is_null() const { return value_.index() == 0; }
  bool is_bool() const { return std::holds_alternative<bool>(value_); }
  bool is_number() const { return std::holds_alternative<double>(value_); }
  bool is_text() const { return std::holds_alternative<std::string>(value_); }
  bool is_array() const { return std::holds_alternative<Array>(value_); }
  bool is_object() const { return std::holds_alternative<Object>(value_); }

  bool bool_or(bool otherwise) const;
  double number_or(double otherwise) const;
  // The text of a string; empty for anything else.
  const std::string& text() const;
  // An integer in [0, 2^32 - 2]; 5.0 is one too.
  std::optional<std::uint32_t> index() const;
  // An integer in [0, 2^53].
  std::optional<std::uint64_t> count() const;

  // Of an array or object.
  std::size_t size() const;
  // The null value where there is none.
  const JsonValue& operator[](std::string_view key) const;
  const JsonValue& operator[](std::size_t i) const;
  bool has(std::string_view key) const { return !(*this)[key].is_null(); }
  const Array& items() const;     // empty when this is no array
  const Object& members() const;  // empty when this is no object

 private:
  friend class JsonBuilder;
  std::variant<std::monostate, bool, double, std::string, Array, Object> value_;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

// The whole text must be one value. The place of an error is "byte N". Refused: a key twice in one
// object, values nested deeper than kMaxJsonDepth, more values than `max_values`.
[[nodiscard]] Expected<JsonValue> parse_json(std::string_view text,
                                             std::size_t max_values = 1u << 27);

}  // namespace dapple
