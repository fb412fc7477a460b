#include "image/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "image/exr.h"
#include "image/hdr.h"
#include "image/pfm.h"
#include "image/png.h"
#include "image/ppm.h"
#include "image/raw_image.h"
#include "image/transfer.h"
#include "util/atomic_file.h"
#include "util/mapped_file.h"

namespace dapple {
namespace {

using Bytes = std::vector<std::byte>;

struct ImageFormat {
  std::string_view ending;                    // lower case
  bool (*matches)(std::string_view content);  // by the first bytes of a file
  Expected<Bytes> (*encode)(const Image&, const ImageWriteOptions&);
  Expected<Image> (*decode)(std::span<const std::byte>, const ImageReadOptions&);
};

bool is_ppm(std::string_view content) {
  return content.size() >= 2 && content[0] == 'P' &&
         std::string_view("2356").find(content[1]) != std::string_view::npos;
}
bool is_png(std::string_view content) { return content.starts_with("\x89PNG\r\n\x1a\n"); }
bool is_exr(std::string_view content) { return content.starts_with("\x76\x2f\x31\x01"); }
bool is_pfm(std::string_view content) {
  return content.starts_with("PF") || content.starts_with("Pf");
}
bool is_hdr(std::string_view content) { return content.starts_with("#?"); }

// The first one is for names that end in nothing we know.
constexpr ImageFormat kFormats[] = {
    {".ppm", is_ppm, encode_ppm, decode_ppm}, {".png", is_png, encode_png, decode_png},
    {".exr", is_exr, encode_exr, decode_exr}, {".pfm", is_pfm, encode_pfm, decode_pfm},
    {".hdr", is_hdr, encode_hdr, decode_hdr},
};

// Formats that are read and not written.
bool is_jpeg(std::string_view content) { return content.starts_with("\xff\xd8\xff"); }
bool is_webp(std::string_view content) {
  return content.starts_with("RIFF") && content.substr(0, 12).ends_with("WEBP");
}

// Eight bits in sRGB, which is what such files are unless a profile says otherwise.
Expected<Image> decode_srgb(std::span<const std::byte> bytes, const ImageReadOptions& options) {
  const auto raw = decode_raw_image(bytes, options.max_pixels);
  if (!raw) return tl::unexpected(raw.error());
  const std::vector<float> table = decode_table(255, Transfer::srgb);
  Image image(static_cast<int>(raw->width), static_cast<int>(raw->height));
  const std::uint8_t* texel = raw->texels.data();
  for (Vec3f& pixel : image.pixels) {
    pixel = {table[texel[0]], table[texel[1]], table[texel[2]]};
    texel += 4;
  }
  return image;
}

bool ends_in(std::string_view name, std::string_view ending) {
  if (name.size() < ending.size()) return false;
  name.remove_prefix(name.size() - ending.size());
  return std::equal(name.begin(), name.end(), ending.begin(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

const ImageFormat& format_of_name(std::string_view name) {
  for (const ImageFormat& format : kFormats) {
    if (ends_in(name, format.ending)) return format;
  }
  return kFormats[0];
}

std::string known_endings() {
  std::string text;
  for (const ImageFormat& format : kFormats) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", format.ending.substr(1));
  }
  return text;
}

Status check_writable(const Image& image) {
  const std::uint64_t count =
      static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.pixels.size() != count) {
    return fail(Errc::internal, "",
                fmt::format("a picture of {} x {} pixels with {} values cannot be written",
                            image.width, image.height, image.pixels.size()));
  }
  if (!image.alpha.empty() && image.alpha.size() != count) {
    return fail(Errc::internal, "", "a picture's alpha is not as large as its colours");
  }
  return {};
}

// "FILE, byte 12" from an error whose place is "byte 12".
tl::unexpected<Error> in_file(Error error, const std::string& path) {
  error.place = error.place.empty() ? path : path + ", " + error.place;
  return tl::unexpected(std::move(error));
}

}  // namespace

std::string_view format_ending(std::string_view path) { return format_of_name(path).ending; }

Expected<Bytes> encode_image(std::string_view name, const Image& image,
                             const ImageWriteOptions& options) try {
  if (auto writable = check_writable(image); !writable) return tl::unexpected(writable.error());
  return format_of_name(name).encode(image, options);
} catch (const std::bad_alloc&) {
  return fail(Errc::memory, "", "out of memory while the picture was encoded");
}

Expected<Image> decode_image(std::span<const std::byte> bytes,
                             const ImageReadOptions& options) try {
  if (bytes.empty()) return fail(Errc::bad_data, "", "the file is empty");
  const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const ImageFormat& format : kFormats) {
    if (format.matches(content)) return format.decode(bytes, options);
  }
  if (is_jpeg(content) || is_webp(content)) return decode_srgb(bytes, options);
  return fail(Errc::bad_data, "",
              fmt::format("not a picture in a known format ({}, jpeg, webp)", known_endings()));
} catch (const std::bad_alloc&) {
  return fail(Errc::memory, "", "out of memory while the picture was decoded");
}

Status write_image(const std::string& path, const Image& image, const ImageWriteOptions& options) {
  const auto bytes = encode_image(path, image, options);
  if (!bytes) return in_file(bytes.error(), path);
  return write_file_atomically(path, *bytes);
}

Expected<Image> read_image(const std::string& path, const ImageReadOptions& options) {
  const auto file = MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  auto image = decode_image(file->bytes(), options);
  if (!image) return in_file(image.error(), path);
  return image;
}

}  // namespace dapple
