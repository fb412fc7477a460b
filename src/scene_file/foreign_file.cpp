#include "scene_file/foreign_file.h"

#include <algorithm>
#include <string_view>

namespace dapple {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view start;
  std::string_view description;
};

constexpr Signature kSignatures[] = {
    {"\x89PNG"sv, "it looks like a PNG image"},
    {"\xff\xd8\xff"sv, "it looks like a JPEG image"},
    {"\x76\x2f\x31\x01"sv, "it looks like an OpenEXR image"},
    {"#?RADIANCE"sv, "it looks like a Radiance HDR image"},
    {"#?RGBE"sv, "it looks like a Radiance HDR image"},
    {"P3"sv, "it looks like a PPM image"},
    {"P5"sv, "it looks like a PGM image"},
    {"P6"sv, "it looks like a PPM image"},
    {"PF"sv, "it looks like a PFM image"},
    {"RIFF"sv, "it looks like a RIFF file (WebP, WAV)"},
    {"glTF"sv, "it looks like a binary glTF scene"},
    {"ply\n"sv, "it looks like a PLY mesh"},
    {"\x7f"
     "ELF"sv,
     "it looks like an ELF program"},
    {"\x1f\x8b"sv, "it looks like gzip-compressed data"},
    {"\x28\xb5\x2f\xfd"sv, "it looks like zstd-compressed data"},
    {"PK\x03\x04"sv, "it looks like a zip archive"},
    {"%PDF"sv, "it looks like a PDF document"},
    {"\x89"
     "DPL"sv,
     "it looks like a scene file that was changed by a transfer in text mode"},
};

bool is_text(unsigned char c) { return c >= 32 || c == '\n' || c == '\r' || c == '\t'; }

}  // namespace

std::string describe_foreign_file(std::span<const std::byte> file) {
  constexpr std::size_t kLookedAt = 512;
  const std::string_view text(reinterpret_cast<const char*>(file.data()),
                              std::min(file.size(), kLookedAt));
  for (const Signature& signature : kSignatures) {
    if (text.starts_with(signature.start)) return std::string(signature.description);
  }
  const auto is_char = [](char wanted) { return [wanted](char c) { return c == wanted; }; };
  if (std::all_of(text.begin(), text.end(), is_char('\0'))) return "it begins with zeros";
  if (!std::all_of(text.begin(), text.end(), [](unsigned char c) { return is_text(c); })) {
    return "it is of no kind that is known here";
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] == '{')
    return "it looks like JSON (a glTF scene?)";
  if (first != std::string_view::npos && text[first] == '<') return "it looks like XML or HTML";
  return "it looks like text";
}

}  // namespace dapple
