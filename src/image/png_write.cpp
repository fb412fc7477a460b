#include <algorithm>
#include <new>

#include "image/png.h"
#include "image/png_session.h"
#include "image/transfer.h"

namespace dapple {
namespace {

struct Writer : PngSession {
  const Image& image;
  const ImageWriteOptions& options;
  std::vector<std::byte> row;
  std::vector<std::byte> bytes;

  Writer(const Image& image_, const ImageWriteOptions& options_)
      : image(image_),
        options(options_),
        row(static_cast<std::size_t>(image_.width) * (image_.alpha.empty() ? 3 : 4) *
            (options_.png_bits == 16 ? 2 : 1)) {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<PngSession*>(this),
                                  png_report_error, png_ignore_warning);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  Writer(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

// An exception must not pass through libpng, and an error of libpng not through a handler.
bool append(std::vector<std::byte>& bytes, const png_byte* data, std::size_t size) {
  try {
    const auto* begin = reinterpret_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void take_bytes(png_structp png, png_bytep data, std::size_t size) {
  auto* bytes = static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
  if (!append(*bytes, data, size)) png_error(png, "out of memory");
}

void flush_nothing(png_structp) {}

// Big-endian.
std::byte* put_sample(std::uint32_t sample, int bits, std::byte* out) {
  if (bits == 16) *out++ = static_cast<std::byte>(sample >> 8);
  *out++ = static_cast<std::byte>(sample);
  return out;
}

// Colours in PNG files are not multiplied by alpha.
Vec3f plain_colour(const Image& image, int x, int y) {
  const Vec3f& pixel = image.at(x, y);
  if (image.alpha.empty()) return pixel;
  const float alpha = image.alpha[image.index(x, y)];
  return alpha > 0.0f ? pixel / alpha : Vec3f();
}

std::uint32_t encode_alpha(float alpha, std::uint32_t max) {
  return static_cast<std::uint32_t>(std::clamp(alpha, 0.0f, 1.0f) * static_cast<float>(max) + 0.5f);
}

void fill_row(Writer& writer, int y) {
  const Image& image = writer.image;
  const int bits = writer.options.png_bits;
  const std::uint32_t max = bits == 16 ? 65535 : 255;
  std::byte* out = writer.row.data();
  for (int x = 0; x < image.width; ++x) {
    const Vec3f colour = plain_colour(image, x, y);
    for (int channel = 0; channel < 3; ++channel) {
      out = put_sample(encode_integer(colour[channel], writer.options.transfer, max), bits, out);
    }
    if (image.alpha.empty()) continue;
    out = put_sample(encode_alpha(image.alpha[image.index(x, y)], max), bits, out);
  }
}

// A third of the default level's time, for files that are a tenth larger at most.
constexpr int kCompressionLevel = 3;

void write_all(Writer& writer) {
  png_structp png = writer.png;
  png_set_write_fn(png, &writer.bytes, take_bytes, flush_nothing);
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
  png_set_compression_level(png, kCompressionLevel);
  png_set_IHDR(png, writer.info, static_cast<png_uint_32>(writer.image.width),
               static_cast<png_uint_32>(writer.image.height), writer.options.png_bits,
               writer.image.alpha.empty() ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (writer.options.transfer == Transfer::srgb) {
    png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  } else {
    png_set_gAMA_fixed(png, writer.info, PNG_FP_1 / 2);
  }
  png_write_info(png, writer.info);
  for (int y = 0; y < writer.image.height; ++y) {
    fill_row(writer, y);
    png_write_row(png, reinterpret_cast<png_const_bytep>(writer.row.data()));
  }
  png_write_end(png, writer.info);
}

}  // namespace

Expected<std::vector<std::byte>> encode_png(const Image& image, const ImageWriteOptions& options) {
  if (options.png_bits != 8 && options.png_bits != 16) {
    return fail(Errc::usage, "", "a PNG file has 8 or 16 bits a channel");
  }
  Writer writer(image, options);
  if (writer.info == nullptr || !png_run(writer, write_all, writer)) {
    return fail(Errc::internal, "", std::string("cannot encode PNG: ") + writer.message);
  }
  return std::move(writer.bytes);
}

}  // namespace dapple
