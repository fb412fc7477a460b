#include "import/gltf/uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace dapple::gltf {
namespace {

constexpr std::string_view kBase64 =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 0xff;

constexpr std::array<std::uint8_t, 256> base64_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoDigit);
  for (std::size_t i = 0; i < kBase64.size(); ++i) {
    values[static_cast<unsigned char>(kBase64[i])] = static_cast<std::uint8_t>(i);
  }
  return values;
}

Expected<std::vector<std::uint8_t>> decode_base64(std::string_view text) {
  static constexpr auto kValues = base64_values();
  while (text.ends_with('=')) text.remove_suffix(1);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
    if (value == kNoDigit) return fail(Errc::bad_data, "", "its data is not base64");
    bits = bits << 6 | value;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  if (text.size() % 4 == 1) return fail(Errc::bad_data, "", "its data is not base64");
  return bytes;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// RFC 3986: a scheme is a letter, then letters, digits, + - . up to a colon before any slash.
bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && colon < std::min(uri.find('/'), uri.size());
}

// RFC 2397: a type, then attributes after semicolons, the last of which may be "base64".
bool is_media_type(std::string_view head) {
  if (head.ends_with(";base64")) head.remove_suffix(7);
  for (std::size_t semicolon = head.find(';'); semicolon != head.npos;
       semicolon = head.find(';', semicolon + 1)) {
    const std::string_view attribute = head.substr(semicolon + 1);
    const std::size_t equals = attribute.substr(0, attribute.find(';')).find('=');
    if (equals == 0 || equals == attribute.npos) return false;
  }
  return true;
}

Expected<std::string> decode_percent(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const bool whole = text.size() - i > 2;
    const int high = whole ? hex_digit(text[i + 1]) : -1;
    const int low = whole ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) return fail(Errc::bad_data, "", "% without two hexadecimal digits");
    decoded += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return decoded;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

Expected<DataUri> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return fail(Errc::bad_data, "", "a data URI without data");
  const std::string_view head = uri.substr(5, comma - 5);
  const std::string_view data = uri.substr(comma + 1);
  if (!is_media_type(head)) {
    return fail(Errc::bad_data, "",
                fmt::format("a data URI of the malformed type \"{}\"", head.substr(0, 60)));
  }
  DataUri result{head.substr(0, head.find(';')), {}};
  if (head.ends_with(";base64")) {
    auto bytes = decode_base64(data);
    if (!bytes) return tl::unexpected(bytes.error());
    result.bytes = std::move(*bytes);
  } else {
    const auto text = decode_percent(data);
    if (!text) return tl::unexpected(text.error());
    result.bytes.assign(text->begin(), text->end());
  }
  return result;
}

Expected<std::string> file_of_uri(std::string_view uri) {
  if (uri.empty()) return fail(Errc::bad_data, "", "an empty URI");
  if (has_scheme(uri) || uri.starts_with("//")) {
    return fail(Errc::bad_data, "",
                fmt::format("\"{}\" is no file beside this one", uri.substr(0, 200)));
  }
  return decode_percent(uri);
}

}  // namespace dapple::gltf
