// Textures keep the numbers and the alpha of their files.
#include "image/raw_image.h"

#include <gtest/gtest.h>
#include <webp/encode.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
// jpeglib.h needs FILE declared before it.
#include <jpeglib.h>

#include "image/formats.h"

namespace dapple {
namespace {

std::span<const std::byte> bytes_of(const unsigned char* data, std::size_t size) {
  return {reinterpret_cast<const std::byte*>(data), size};
}

std::vector<std::uint8_t> ramp(std::size_t pixels) {
  std::vector<std::uint8_t> texels;
  for (std::size_t i = 0; i < pixels * 4; ++i) texels.push_back(static_cast<std::uint8_t>(i * 7));
  return texels;
}

TEST(RawImage, LosslessWebpKeepsEveryByte) {
  const auto texels = ramp(8 * 4);
  std::uint8_t* data = nullptr;
  WebPConfig config;
  ASSERT_TRUE(WebPConfigPreset(&config, WEBP_PRESET_DEFAULT, 50));
  config.lossless = 1;
  config.exact = 1;  // also where alpha is zero
  WebPPicture picture;
  ASSERT_TRUE(WebPPictureInit(&picture));
  picture.use_argb = 1;
  picture.width = 8;
  picture.height = 4;
  ASSERT_TRUE(WebPPictureImportRGBA(&picture, texels.data(), 32));
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &writer;
  ASSERT_TRUE(WebPEncode(&config, &picture));
  data = writer.mem;
  const auto image = decode_raw_image(bytes_of(data, writer.size));
  ASSERT_TRUE(image.has_value()) << to_string(image.error());
  EXPECT_EQ(image->width, 8u);
  EXPECT_EQ(image->height, 4u);
  EXPECT_EQ(image->texels, texels);
  for (std::size_t size = 0; size < writer.size; ++size) {
    EXPECT_FALSE(decode_raw_image(bytes_of(data, size)).has_value()) << size;
  }
  EXPECT_FALSE(decode_raw_image(bytes_of(data, writer.size), 31).has_value());
  WebPPictureFree(&picture);
  WebPMemoryWriterClear(&writer);
}

std::vector<unsigned char> grey_jpeg(unsigned width, unsigned height, unsigned char level) {
  jpeg_compress_struct encoder{};
  jpeg_error_mgr errors{};
  encoder.err = jpeg_std_error(&errors);
  jpeg_create_compress(&encoder);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&encoder, &data, &size);
  encoder.image_width = width;
  encoder.image_height = height;
  encoder.input_components = 3;
  encoder.in_color_space = JCS_RGB;
  jpeg_set_defaults(&encoder);
  jpeg_start_compress(&encoder, TRUE);
  std::vector<unsigned char> row(width * 3, level);
  JSAMPROW rows = row.data();
  while (encoder.next_scanline < height) jpeg_write_scanlines(&encoder, &rows, 1);
  jpeg_finish_compress(&encoder);
  std::vector<unsigned char> bytes(data, data + size);
  jpeg_destroy_compress(&encoder);
  std::free(data);
  return bytes;
}

TEST(RawImage, PicturesThatAreOnlyReadAreInSrgb) {
  const auto file = grey_jpeg(9, 5, 188);
  const auto image = decode_image(bytes_of(file.data(), file.size()));
  ASSERT_TRUE(image) << to_string(image.error());
  EXPECT_EQ(image->width, 9);
  EXPECT_EQ(image->height, 5);
  for (const Vec3f& pixel : image->pixels) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel[c], 0.503f, 0.01f);  // a step of the file's
  }
  EXPECT_FALSE(decode_image(bytes_of(file.data(), file.size()), {Transfer::srgb, 44}));
}

TEST(RawImage, JpegIsOpaqueAndKeepsFlatColours) {
  const auto file = grey_jpeg(17, 9, 100);
  const auto image = decode_raw_image(bytes_of(file.data(), file.size()));
  ASSERT_TRUE(image.has_value()) << to_string(image.error());
  ASSERT_EQ(image->texels.size(), 17u * 9 * 4);
  for (std::size_t i = 0; i < image->texels.size(); i += 4) {
    EXPECT_NEAR(image->texels[i], 100, 1);
    EXPECT_EQ(image->texels[i + 3], 255);
  }
}

TEST(RawImage, TruncatedJpegsAreErrors) {
  const auto file = grey_jpeg(64, 64, 100);
  for (std::size_t size = 0; size + 2 < file.size(); ++size) {
    EXPECT_FALSE(decode_raw_image(bytes_of(file.data(), size)).has_value()) << size;
  }
}

TEST(RawImage, PngSamplesPassThroughNoCurve) {
  Image picture(3, 1);
  picture.pixels = {{0, 0, 0}, {1, 1, 1}, {0.2158605f, 0.2158605f, 0.2158605f}};
  for (const int bits : {8, 16}) {
    const auto file = encode_image("x.png", picture, {Transfer::srgb, bits});
    ASSERT_TRUE(file.has_value());
    const auto image = decode_raw_image(*file);
    ASSERT_TRUE(image.has_value()) << to_string(image.error());
    EXPECT_EQ(image->format, bits == 8 ? RawFormat::rgba8 : RawFormat::rgba16);
    ASSERT_EQ(image->texels.size(), 3 * raw_pixel_bytes(image->format));
    // sRGB of that grey is a half: its highest byte is 128, after two bytes of little-endian order.
    const std::size_t last = 2 * raw_pixel_bytes(image->format);
    EXPECT_NEAR(image->texels[last + (bits == 8 ? 0 : 1)], 128, 1);
    EXPECT_EQ(image->texels.back(), 255);
  }
}

TEST(RawImage, HdrAndExrStayLinearFloats) {
  Image picture(2, 2);
  picture.pixels.assign(4, {4, 0.5f, 0.25f});
  for (const char* name : {"x.hdr", "x.exr"}) {
    const auto image = decode_raw_image(*encode_image(name, picture, {}));
    ASSERT_TRUE(image.has_value()) << to_string(image.error());
    EXPECT_EQ(image->format, RawFormat::rgb32f);
    ASSERT_EQ(image->texels.size(), 48u);
    float first = 0;
    std::memcpy(&first, image->texels.data(), sizeof first);
    EXPECT_EQ(first, 4);
  }
}

}  // namespace
}  // namespace dapple
