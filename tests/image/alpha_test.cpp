// Alpha in files: PNG keeps colours apart from it, EXR multiplied by it.
#include <gtest/gtest.h>

#include <cstring>

#include "image/formats.h"
#include "image/raw_image.h"

namespace dapple {
namespace {

// Half-covered white, nothing, and opaque linear 0.25 (sRGB 137).
Image veiled() {
  Image image(3, 1);
  image.pixels = {{0.5f, 0.5f, 0.5f}, {0, 0, 0}, {0.25f, 0.25f, 0.25f}};
  image.alpha = {0.5f, 0, 1};
  return image;
}

std::vector<std::uint8_t> texels_of(int png_bits) {
  ImageWriteOptions options;
  options.png_bits = png_bits;
  const auto bytes = encode_image("x.png", veiled(), options);
  EXPECT_TRUE(bytes);
  const auto raw = decode_raw_image(*bytes);
  EXPECT_TRUE(raw);
  return raw->texels;
}

TEST(Alpha, PngColoursAreNotMultiplied) {
  EXPECT_EQ(texels_of(8),
            (std::vector<std::uint8_t>{255, 255, 255, 128, 0, 0, 0, 0, 137, 137, 137, 255}));
}

TEST(Alpha, PngOf16Bits) {
  const auto texels = texels_of(16);
  std::uint16_t words[12];
  ASSERT_EQ(texels.size(), sizeof words);
  std::memcpy(words, texels.data(), sizeof words);
  EXPECT_EQ(words[0], 65535);
  EXPECT_EQ(words[3], 32768);
  EXPECT_EQ(words[7], 0);
  EXPECT_EQ(words[11], 65535);
}

TEST(Alpha, ExrColoursStayMultiplied) {
  for (const bool as_float : {false, true}) {
    ImageWriteOptions options;
    options.exr_float = as_float;
    const auto bytes = encode_image("x.exr", veiled(), options);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(decode_image(*bytes)->pixels, veiled().pixels);
    const std::string content(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    // A channel's name, then its type: 1 half, 2 float.
    EXPECT_NE(content.find(std::string("A\0", 2) + (as_float ? '\2' : '\1')), std::string::npos);
  }
}

TEST(Alpha, IsReadWhereItIsAskedFor) {
  ImageReadOptions read;
  read.alpha = true;
  for (const char* name : {"x.png", "x.exr"}) {
    ImageWriteOptions options;
    options.png_bits = 16;
    options.exr_float = true;
    const auto bytes = encode_image(name, veiled(), options);
    ASSERT_TRUE(bytes);
    const auto image = decode_image(*bytes, read);
    ASSERT_TRUE(image && image->alpha.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(image->alpha[i], veiled().alpha[i], 1.0 / 65535);
      EXPECT_NEAR(image->pixels[i].x, veiled().pixels[i].x, 2.0 / 65535);
    }
    EXPECT_TRUE(decode_image(*bytes)->alpha.empty());
    const auto opaque = encode_image(name, Image(2, 1), options);
    EXPECT_TRUE(decode_image(*opaque, read)->alpha.empty());
  }
}

TEST(Alpha, MustBeAsLargeAsThePicture) {
  Image image = veiled();
  image.alpha.pop_back();
  EXPECT_FALSE(encode_image("x.png", image, {}));
}

}  // namespace
}  // namespace dapple
