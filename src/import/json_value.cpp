#include "import/json_value.h"

#include <cmath>

namespace dapple {
namespace {

const JsonValue kNull;

template <class T, class Variant>
const T& alternative_or_empty(const Variant& value) {
  static const T empty{};
  const T* found = std::get_if<T>(&value);
  return found != nullptr ? *found : empty;
}

std::optional<double> integer(double value, double greatest) {
  if (!(value >= 0 && value <= greatest) || value != std::floor(value)) return std::nullopt;
  return value;
}

}  // namespace

bool JsonValue::bool_or(bool otherwise) const {
  const bool* found = std::get_if<bool>(&value_);
  return found != nullptr ? *found : otherwise;
}

double JsonValue::number_or(double otherwise) const {
  const double* found = std::get_if<double>(&value_);
  return found != nullptr ? *found : otherwise;
}

const std::string& JsonValue::text() const { return alternative_or_empty<std::string>(value_); }
const JsonValue::Array& JsonValue::items() const { return alternative_or_empty<Array>(value_); }
const JsonValue::Object& JsonValue::members() const { return alternative_or_empty<Object>(value_); }

std::optional<std::uint32_t> JsonValue::index() const {
  const auto value = integer(number_or(-1), 4294967294.0);
  if (!value) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

std::optional<std::uint64_t> JsonValue::count() const {
  const auto value = integer(number_or(-1), 9007199254740992.0);
  if (!value) return std::nullopt;
  return static_cast<std::uint64_t>(*value);
}

std::size_t JsonValue::size() const { return items().size() + members().size(); }

const JsonValue& JsonValue::operator[](std::string_view key) const {
  for (const JsonMember& member : members()) {
    if (member.key == key) return member.value;
  }
  return kNull;
}

const JsonValue& JsonValue::operator[](std::size_t i) const {
  return i < items().size() ? items()[i] : kNull;
}

}  // namespace dapple
