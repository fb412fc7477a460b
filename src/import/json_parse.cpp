#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "import/json_value.h"
#include "import/limits.h"

namespace dapple {

constexpr std::size_t kShown = 40;       // bytes of what the parser read last
constexpr std::size_t kMaxReason = 300;  // bytes

// Receives the events of nlohmann's parser, which itself does not recurse.
class JsonBuilder {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  explicit JsonBuilder(std::size_t max_values) : values_left_(max_values) {}

  bool null() { return add(JsonValue()) != nullptr; }
  bool boolean(bool value) { return add(JsonValue(value)) != nullptr; }
  bool number_integer(number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) { return number(value); }
  bool string(string_t& value) { return add(JsonValue(std::move(value))) != nullptr; }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return open(JsonValue(JsonValue::Object())); }
  bool start_array(std::size_t) { return open(JsonValue(JsonValue::Array())); }
  bool end_array() { return close(); }

  bool key(string_t& name) {
    key_ = std::move(name);
    return true;
  }

  bool end_object() {
    std::vector<std::string_view> keys;
    for (const JsonMember& member : open_.back()->members()) keys.push_back(member.key);
    std::sort(keys.begin(), keys.end());
    const auto twice = std::adjacent_find(keys.begin(), keys.end());
    if (twice != keys.end()) {
      reason_ = fmt::format("an object has two members \"{}\"", *twice);
      return false;
    }
    return close();
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& error) {
    position_ = position;
    reason_ = shortened(error.what());
    return false;
  }

  JsonValue take() { return std::move(root_); }
  tl::unexpected<Error> error() const {
    return fail(Errc::bad_data, position_ > 0 ? fmt::format("byte {}", position_) : "",
                "not valid JSON: " + reason_);
  }

 private:
  // From "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ... -
  // invalid string: missing closing quote; last read: '...'; expected ...": what was last read is
  // as long as the file's strings are.
  static std::string shortened(std::string reason) {
    const std::size_t at = reason.find(" at line ");
    if (at != std::string::npos) reason.erase(0, at + 1);
    constexpr std::string_view kRead = "last read: '";
    const std::size_t read = reason.find(kRead);
    const std::size_t end = reason.rfind('\'');
    if (read != std::string::npos && end > read + kRead.size() + kShown) {
      reason.replace(read + kRead.size() + kShown, end - read - kRead.size() - kShown, "...");
    }
    if (reason.size() > kMaxReason) reason.replace(kMaxReason, std::string::npos, "...");
    for (char& c : reason) {
      if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
    }
    return reason;
  }

  bool number(double value) { return add(JsonValue(value)) != nullptr; }

  // Containers of the stack stay where they are: only the innermost one grows.
  JsonValue* add(JsonValue value) {
    if (values_left_ == 0) {
      reason_ = "it has too many values";
      return nullptr;
    }
    --values_left_;
    if (open_.empty()) return &(root_ = std::move(value));
    JsonValue& parent = *open_.back();
    if (auto* array = std::get_if<JsonValue::Array>(&parent.value_)) {
      return &array->emplace_back(std::move(value));
    }
    auto& object = std::get<JsonValue::Object>(parent.value_);
    return &object.emplace_back(JsonMember{std::move(key_), std::move(value)}).value;
  }

  bool open(JsonValue value) {
    if (open_.size() == kMaxJsonDepth) {
      reason_ = fmt::format("its values are nested deeper than {}", kMaxJsonDepth);
      return false;
    }
    JsonValue* const added = add(std::move(value));
    if (added != nullptr) open_.push_back(added);
    return added != nullptr;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::size_t values_left_;
  JsonValue root_;
  std::vector<JsonValue*> open_;
  std::string key_;
  std::size_t position_ = 0;
  std::string reason_;
};

Expected<JsonValue> parse_json(std::string_view text, std::size_t max_values) {
  JsonBuilder builder(max_values);
  const bool parsed = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  if (!parsed) return builder.error();
  return builder.take();
}

}  // namespace dapple
