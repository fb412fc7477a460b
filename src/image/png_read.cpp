#include <algorithm>
#include <cstring>

#include "image/decoding.h"
#include "image/png.h"
#include "image/png_session.h"
#include "image/transfer.h"

namespace dapple {
namespace {

enum class Alpha {
  strip,
  keep,  // where there is any
  add,   // rgba, little-endian, whatever the file has; otherwise samples are big-endian
};

struct Reader : PngSession {
  std::span<const std::byte> bytes;
  std::size_t position = 0;
  png_uint_32 width = 0, height = 0;
  int bits = 0;              // of a sample, after palettes and bits are expanded: 8 or 16
  std::size_t row_size = 0;  // after expansion
  Alpha alpha = Alpha::strip;
  int channels = 3;  // of a pixel, after expansion
  bool has_srgb = false;
  png_fixed_point gamma = 0;  // of the gAMA chunk, times 100000; 0: none
  std::uint64_t least_size = 0;
  std::vector<png_byte> samples;
  std::vector<png_bytep> rows;

  Reader(std::span<const std::byte> bytes_, Alpha alpha_) : bytes(bytes_), alpha(alpha_) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<PngSession*>(this),
                                 png_report_error, png_ignore_warning);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  Reader(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void give_bytes(png_structp png, png_bytep data, std::size_t size) {
  auto* reader = static_cast<Reader*>(png_get_io_ptr(png));
  if (size > reader->bytes.size() - reader->position) png_error(png, "the file ends early");
  std::memcpy(data, reader->bytes.data() + reader->position, size);
  reader->position += size;
}

// Chunks that we do not use: skipped, so that their length and what is packed in them take no
// memory.
constexpr png_byte kSkippedChunks[] = "eXIf\0hIST\0iCCP\0iTXt\0pCAL\0sCAL\0sPLT\0tEXt\0zTXt";

void set_limits(Reader& reader) {
  png_set_user_limits(reader.png, 0x7fffffff, 0x7fffffff);
  png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, kSkippedChunks,
                              sizeof kSkippedChunks / 5);
  png_set_chunk_malloc_max(reader.png, 0);  // no limit
  // A damaged gAMA chunk is damage too: without it the picture would look different.
  png_set_crc_action(reader.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
}

// Deflate makes at most 1032 bytes of one [RFC 1951]; a filter byte stands before each row.
std::uint64_t least_file_size(const Reader& reader) {
  const std::uint64_t row = png_get_rowbytes(reader.png, reader.info) + 1;
  return row * reader.height / 1032;
}

void read_header(Reader& reader) {
  png_set_read_fn(reader.png, &reader, give_bytes);
  set_limits(reader);
  png_read_info(reader.png, reader.info);
  reader.width = png_get_image_width(reader.png, reader.info);
  reader.height = png_get_image_height(reader.png, reader.info);
  reader.has_srgb = png_get_valid(reader.png, reader.info, PNG_INFO_sRGB) != 0;
  png_get_gAMA_fixed(reader.png, reader.info, &reader.gamma);
  reader.least_size = least_file_size(reader);

  png_set_expand(reader.png);
  png_set_gray_to_rgb(reader.png);
  if (reader.alpha == Alpha::add) {
    png_set_add_alpha(reader.png, 0xffff, PNG_FILLER_AFTER);
    png_set_swap(reader.png);
  } else if (reader.alpha == Alpha::strip) {
    png_set_strip_alpha(reader.png);
  }
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  reader.bits = png_get_bit_depth(reader.png, reader.info);
  reader.channels = png_get_channels(reader.png, reader.info);
  reader.row_size = png_get_rowbytes(reader.png, reader.info);
}

void read_pixels(Reader& reader) {
  png_read_image(reader.png, reader.rows.data());
  png_read_end(reader.png, nullptr);
}

tl::unexpected<Error> damaged(const Reader& reader) {
  return bad_byte(reader.position, std::string("damaged PNG: ") + reader.message);
}

void allocate_rows(Reader& reader) {
  reader.samples.resize(reader.row_size * reader.height);
  reader.rows.resize(reader.height);
  for (std::size_t y = 0; y < reader.rows.size(); ++y) {
    reader.rows[y] = reader.samples.data() + y * reader.row_size;
  }
}

std::vector<float> sample_table(const Reader& reader, const ImageReadOptions& options) {
  const std::uint32_t max = reader.bits == 16 ? 65535 : 255;
  if (reader.has_srgb) return decode_table(max, Transfer::srgb);
  if (reader.gamma == PNG_FP_1 / 2) return decode_table(max, Transfer::gamma2);
  if (reader.gamma > 0) return decode_table(max, reader.gamma / double{PNG_FP_1});
  return decode_table(max, options.untagged);
}

void fill(Image& image, const Reader& reader, const std::vector<float>& table) {
  const png_byte* in = reader.samples.data();
  const auto next = [&] {
    std::size_t sample = *in++;
    if (reader.bits == 16) sample = sample << 8 | *in++;
    return sample;
  };
  if (reader.channels == 4) image.alpha.resize(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    Vec3f& pixel = image.pixels[i];
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = table[next()];
    if (reader.channels < 4) continue;
    image.alpha[i] = static_cast<float>(next()) / (reader.bits == 16 ? 65535.0f : 255.0f);
    pixel = image.alpha[i] * pixel;
  }
}

}  // namespace

Expected<Image> decode_png(std::span<const std::byte> bytes, const ImageReadOptions& options) {
  Reader reader(bytes, options.alpha ? Alpha::keep : Alpha::strip);
  if (reader.info == nullptr) return fail(Errc::memory, "", reader.message);
  if (!png_run(reader, read_header, reader)) return damaged(reader);
  auto image =
      allocate_image(reader.width, reader.height, reader.least_size, bytes.size(), options);
  if (!image) return image;
  allocate_rows(reader);
  if (!png_run(reader, read_pixels, reader)) return damaged(reader);
  fill(*image, reader, sample_table(reader, options));
  return image;
}

Expected<RawImage> decode_raw_png(std::span<const std::byte> bytes, std::uint64_t max_pixels) {
  Reader reader(bytes, Alpha::add);
  if (reader.info == nullptr) return fail(Errc::memory, "", reader.message);
  if (!png_run(reader, read_header, reader)) return damaged(reader);
  if (auto allowed = check_picture_size(reader.width, reader.height, max_pixels); !allowed) {
    return tl::unexpected(allowed.error());
  }
  if (bytes.size() < reader.least_size) return bad_byte(bytes.size(), "the file ends early");
  allocate_rows(reader);
  if (!png_run(reader, read_pixels, reader)) return damaged(reader);
  const RawFormat format = reader.bits == 16 ? RawFormat::rgba16 : RawFormat::rgba8;
  return RawImage{reader.width, reader.height, format, std::move(reader.samples)};
}

}  // namespace dapple
