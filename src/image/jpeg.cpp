#include "image/jpeg.h"

#include <csetjmp>
#include <cstdio>
// jpeglib.h needs FILE declared before it.
#include <jpeglib.h>

#include "image/decoding.h"

namespace dapple {
namespace {

// libjpeg reports errors by a callback that may not return: it jumps back to the step that called.
struct Session {
  jpeg_decompress_struct decoder{};
  jpeg_error_mgr errors{};
  std::jmp_buf back{};
  char message[JMSG_LENGTH_MAX] = "";
  std::span<const std::byte> bytes;
  std::uint8_t* texels = nullptr;

  Session() = default;
  Session(const Session&) = delete;
  ~Session() { jpeg_destroy_decompress(&decoder); }
};

void report_error(j_common_ptr decoder) {
  auto* session = static_cast<Session*>(decoder->client_data);
  decoder->err->format_message(decoder, session->message);
  std::longjmp(session->back, 1);
}

// Warnings are damage too (data that ends early, say): a texture half grey would render silently.
void report_message(j_common_ptr decoder, int level) {
  if (level < 0) report_error(decoder);
}

void read_header(Session& session) {
  session.decoder.err = jpeg_std_error(&session.errors);
  session.errors.error_exit = report_error;
  session.errors.emit_message = report_message;
  session.decoder.client_data = &session;
  jpeg_create_decompress(&session.decoder);
  session.decoder.client_data = &session;
  jpeg_mem_src(&session.decoder, reinterpret_cast<const unsigned char*>(session.bytes.data()),
               session.bytes.size());
  jpeg_read_header(&session.decoder, TRUE);
}

bool is_four_inks(const jpeg_decompress_struct& decoder) {
  return decoder.jpeg_color_space == JCS_CMYK || decoder.jpeg_color_space == JCS_YCCK;
}

// The accurate integer transform: the same bytes whatever SIMD code libjpeg-turbo chooses.
void read_pixels(Session& session) {
  jpeg_decompress_struct& decoder = session.decoder;
  decoder.out_color_space = is_four_inks(decoder) ? JCS_CMYK : JCS_EXT_RGBA;
  decoder.dct_method = JDCT_ISLOW;
  decoder.do_fancy_upsampling = TRUE;
  jpeg_start_decompress(&decoder);
  const std::size_t stride = std::size_t{decoder.output_width} * 4;
  while (decoder.output_scanline < decoder.output_height) {
    JSAMPROW row = session.texels + decoder.output_scanline * stride;
    jpeg_read_scanlines(&decoder, &row, 1);
  }
  jpeg_finish_decompress(&decoder);
}

// Runs a step, which must be written like C: no objects with destructors.
bool run(Session& session, void (*step)(Session&)) {
  if (setjmp(session.back) != 0) return false;
  step(session);
  return true;
}

tl::unexpected<Error> damaged(const Session& session) {
  return fail(Errc::bad_data, "", std::string("damaged JPEG: ") + session.message);
}

// Adobe's files store the inks inverted: 255 is no ink.
void rgba_from_inverted_cmyk(std::vector<std::uint8_t>& texels) {
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    const unsigned black = texels[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      texels[i + c] = static_cast<std::uint8_t>((texels[i + c] * black + 127) / 255);
    }
    texels[i + 3] = 255;
  }
}

}  // namespace

Expected<RawImage> decode_raw_jpeg(std::span<const std::byte> bytes, std::uint64_t max_pixels) {
  Session session;
  session.bytes = bytes;
  if (!run(session, read_header)) return damaged(session);
  RawImage image;
  image.width = session.decoder.image_width;
  image.height = session.decoder.image_height;
  if (auto allowed = check_picture_size(image.width, image.height, max_pixels); !allowed) {
    return tl::unexpected(allowed.error());
  }
  // A block of 64 pixels takes at least a few bits; progressive files may leave out even those.
  const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
  if (bytes.size() < pixels / 16384) {
    return fail(Errc::bad_data, "", "damaged JPEG: far too short for its size");
  }
  image.texels.resize(pixels * 4);
  session.texels = image.texels.data();
  if (!run(session, read_pixels)) return damaged(session);
  if (is_four_inks(session.decoder)) rgba_from_inverted_cmyk(image.texels);
  return image;
}

}  // namespace dapple
