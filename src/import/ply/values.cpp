#include "import/ply/values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "import/text.h"

namespace dapple::ply {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
double from_bytes(const std::byte* bytes, bool big_endian) {
  std::byte ordered[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i)
    ordered[i] = bytes[big_endian ? sizeof(T) - 1 - i : i];
  T value;
  std::memcpy(&value, ordered, sizeof(T));
  return static_cast<double>(value);
}

double decoded(Type type, const std::byte* bytes, bool big_endian) {
  switch (type) {
    case Type::i8:
      return from_bytes<std::int8_t>(bytes, big_endian);
    case Type::u8:
      return from_bytes<std::uint8_t>(bytes, big_endian);
    case Type::i16:
      return from_bytes<std::int16_t>(bytes, big_endian);
    case Type::u16:
      return from_bytes<std::uint16_t>(bytes, big_endian);
    case Type::i32:
      return from_bytes<std::int32_t>(bytes, big_endian);
    case Type::u32:
      return from_bytes<std::uint32_t>(bytes, big_endian);
    case Type::f32:
      return from_bytes<float>(bytes, big_endian);
    case Type::f64:
      return from_bytes<double>(bytes, big_endian);
  }
  return 0;
}

bool is_integer(Type type) { return type != Type::f32 && type != Type::f64; }

bool is_space(char c) { return is_blank(c) || c == '\n'; }

}  // namespace

ValueReader::ValueReader(std::span<const std::byte> bytes, const Header& header,
                         std::string_view name)
    : bytes_(bytes),
      name_(name),
      format_(header.format),
      position_(std::min(header.bytes, bytes.size())),
      line_(header.lines + 1) {}

double ValueReader::next(Type type) {
  if (bad_) return 0;
  return format_ == Format::ascii ? next_word(type) : next_bytes(type);
}

double ValueReader::next_bytes(Type type) {
  const std::size_t size = bytes_of(type);
  if (bytes_.size() - position_ < size) return give_up("the file ends too early");
  const double value = decoded(type, bytes_.data() + position_, format_ == Format::big_endian);
  position_ += size;
  return value;
}

double ValueReader::next_word(Type type) {
  const std::string_view text = as_text(bytes_);
  while (position_ < text.size() && is_space(text[position_])) {
    if (text[position_] == '\n') ++line_;
    ++position_;
  }
  const std::size_t start = position_;
  while (position_ < text.size() && !is_space(text[position_])) ++position_;
  if (start == position_) return give_up("the file ends too early");
  const auto value = to_number(text.substr(start, position_ - start));
  if (!value) return give_up("this is not a number");
  if (is_integer(type) && std::floor(*value) != *value) return give_up("this is not an integer");
  return *value;
}

double ValueReader::give_up(const char* reason) {
  bad_ = true;
  reason_ = reason;
  return 0;
}

std::size_t ValueReader::next_count(const Property& list) {
  const double count = next(list.count_type);
  const std::size_t item = format_ == Format::ascii ? 2 : bytes_of(list.type);
  const auto most = static_cast<double>((bytes_.size() - position_ + 1) / item);
  if (!(count >= 0 && count <= most)) {
    give_up(count < 0 ? "a list has a negative length" : "a list is longer than the file");
    return 0;
  }
  return static_cast<std::size_t>(count);
}

void ValueReader::skip(const Property& property) {
  const std::size_t count = property.is_list ? next_count(property) : 1;
  for (std::size_t i = 0; i < count && !bad_; ++i) next(property.type);
}

tl::unexpected<Error> ValueReader::error(std::string message) const {
  return fail(Errc::bad_data,
              format_ == Format::ascii ? line_place(name_, line_) : byte_place(name_, position_),
              std::move(message));
}

}  // namespace dapple::ply
