#include "util/utf8.h"

#include <cstdint>

namespace dapple {
namespace {

// How many bytes a character with this first byte has; 0 when none begins so.
std::size_t length_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xc2) return 0;
  if (first < 0xe0) return 2;
  if (first < 0xf0) return 3;
  return first < 0xf5 ? 4 : 0;
}

// What the second byte must be in after some first bytes.
bool second_is_allowed(unsigned char first, unsigned char second) {
  if (first == 0xe0) return second >= 0xa0;  // not shorter
  if (first == 0xed) return second < 0xa0;   // no surrogate
  if (first == 0xf0) return second >= 0x90;  // not shorter
  if (first == 0xf4) return second < 0x90;   // not beyond U+10FFFF
  return true;
}

}  // namespace

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[i + k]); };
    const std::size_t length = length_of(byte(0));
    if (length == 0 || length > text.size() - i) return false;
    for (std::size_t k = 1; k < length; ++k) {
      if ((byte(k) & 0xc0) != 0x80) return false;
    }
    if (length > 1 && !second_is_allowed(byte(0), byte(1))) return false;
    i += length;
  }
  return true;
}

}  // namespace dapple
