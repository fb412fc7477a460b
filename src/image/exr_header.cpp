#include "image/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "image/decoding.h"

namespace dapple {
namespace {

using Bytes = std::span<const std::byte>;

struct FixedSize {
  std::string_view type;
  std::size_t size;
};

constexpr FixedSize kFixedSizes[] = {
    {"box2f", 16},         {"box2i", 16},   {"chromaticities", 32},
    {"compression", 1},    {"double", 8},   {"envmap", 1},
    {"deepImageState", 1}, {"float", 4},    {"int", 4},
    {"m33d", 72},          {"keycode", 28}, {"lineOrder", 1},
    {"m33f", 36},          {"m44d", 128},   {"rational", 8},
    {"tiledesc", 9},       {"timecode", 8}, {"m44f", 64},
    {"v2d", 16},           {"v2f", 8},      {"v2i", 8},
    {"v3d", 24},           {"v3f", 12},     {"v3i", 12},
};

// Reads forward; every result is empty once the bytes run out.
class Cursor {
 public:
  explicit Cursor(Bytes bytes) : bytes_(bytes) {}

  std::size_t position() const { return position_; }
  bool at_end() const { return position_ == bytes_.size(); }

  std::optional<Bytes> take(std::uint64_t size) {
    if (size > bytes_.size() - position_) return std::nullopt;
    const Bytes part = bytes_.subspan(position_, size);
    position_ += size;
    return part;
  }

  std::optional<std::uint32_t> take_integer() {
    const auto part = take(4);
    if (!part) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value |= std::to_integer<std::uint32_t>((*part)[i]) << (8 * i);
    }
    return value;
  }

  // Up to a zero byte, which is read too.
  std::optional<std::string_view> take_text() {
    const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(position_);
    const auto end = std::find(begin, bytes_.end(), std::byte{0});
    if (end == bytes_.end()) return std::nullopt;
    const auto text = *take(static_cast<std::size_t>(end - begin) + 1);
    return std::string_view(reinterpret_cast<const char*>(text.data()), text.size() - 1);
  }

 private:
  Bytes bytes_;
  std::size_t position_ = 0;
};

// Name, then type, linearity and sampling in 16 bytes; an empty name ends the list.
bool is_channel_list(Bytes value) {
  Cursor cursor(value);
  for (;;) {
    const auto name = cursor.take_text();
    if (!name) return false;
    if (name->empty()) return cursor.at_end();
    if (!cursor.take(16)) return false;
  }
}

bool is_preview(Bytes value) {
  Cursor cursor(value);
  const auto width = cursor.take_integer();
  const auto height = cursor.take_integer();
  constexpr std::uint32_t kMaxSide = 0xffff;
  return width && height && *width <= kMaxSide && *height <= kMaxSide &&
         cursor.take(std::uint64_t{*width} * *height * 4) && cursor.at_end();
}

bool is_string_vector(Bytes value) {
  Cursor cursor(value);
  while (!cursor.at_end()) {
    const auto size = cursor.take_integer();
    if (!size || !cursor.take(*size)) return false;
  }
  return true;
}

// Whatever type is not listed here is text or is kept by OpenEXR as so many bytes.
bool is_sound(std::string_view type, Bytes value) {
  for (const FixedSize& fixed : kFixedSizes) {
    if (fixed.type == type) return value.size() == fixed.size;
  }
  if (type == "chlist") return is_channel_list(value);
  if (type == "preview") return is_preview(value);
  if (type == "stringvector") return is_string_vector(value);
  if (type == "floatvector") return value.size() % 4 == 0;
  return type != "idmanifest";  // a compressed table for deep pictures, which are not read
}

}  // namespace

Status check_exr_header(Bytes bytes) {
  constexpr std::size_t kMagicAndVersion = 8;
  Cursor cursor(bytes);
  if (!cursor.take(kMagicAndVersion)) return bad_byte(bytes.size(), "the file ends early");
  for (;;) {
    const std::size_t start = cursor.position();
    const auto name = cursor.take_text();
    if (name && name->empty()) return {};
    const auto type = cursor.take_text();
    const auto size = cursor.take_integer();
    const auto value = cursor.take(size.value_or(0));
    if (!name || !type || !size || !value) {
      return bad_byte(start, "damaged EXR: an attribute does not end within the file");
    }
    if (!is_sound(*type, *value)) {
      return bad_byte(start, "damaged EXR: the value of an attribute has the wrong size");
    }
  }
}

}  // namespace dapple
