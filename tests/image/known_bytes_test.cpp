// Whole files of a few pixels, byte by byte.
#include <gtest/gtest.h>

#include "tests/image/sample_images.h"

namespace dapple {
namespace {

using namespace std::string_literals;

// Red and green above blue and black.
Image four_pixels() {
  Image image(2, 2);
  image.pixels = {{1, 0, 0}, {0, 0.25f, 0}, {0, 0, 0.5f}, {0, 0, 0}};
  return image;
}

std::string encoded(const std::string& name, const Image& image, Transfer transfer) {
  return to_text(encode_image(name, image, {transfer, 8, false}).value());
}

TEST(KnownBytes, Ppm) {
  EXPECT_EQ(encoded("a.ppm", four_pixels(), Transfer::gamma2),
            "P6\n2 2\n255\n"
            "\xff\x00\x00"
            "\x00\x80\x00"
            "\x00\x00\xb4"
            "\x00\x00\x00"s);
  EXPECT_EQ(encoded("a.ppm", four_pixels(), Transfer::srgb),
            "P6\n2 2\n255\n"
            "\xff\x00\x00"
            "\x00\x89\x00"
            "\x00\x00\xbc"
            "\x00\x00\x00"s);
}

TEST(KnownBytes, PfmHasTheBottomRowFirst) {
  EXPECT_EQ(encoded("a.pfm", four_pixels(), Transfer::srgb),
            "PF\n2 2\n-1.0\n"
            "\0\0\0\0\0\0\0\0\x00\x00\x00\x3f"
            "\0\0\0\0\0\0\0\0\0\0\0\0"
            "\x00\x00\x80\x3f\0\0\0\0\0\0\0\0"
            "\0\0\0\0\x00\x00\x80\x3e\0\0\0\0"s);
}

TEST(KnownBytes, HdrNarrowLinesAreFlat) {
  EXPECT_EQ(encoded("a.hdr", four_pixels(), Transfer::srgb),
            "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n"
            "\x80\0\0\x81"
            "\0\x80\0\x7f"
            "\0\0\x80\x80"
            "\0\0\0\0"s);
}

TEST(KnownBytes, HdrWideLinesAreRunLengthEncoded) {
  Image image = constant_image(10, 1, {1, 0, 0.5f});
  for (int x = 0; x < 3; ++x) image.at(x, 0).y = 0.25f * static_cast<float>(x + 1);
  EXPECT_EQ(encoded("a.hdr", image, Transfer::srgb),
            "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 10\n"
            "\x02\x02\x00\x0a"
            "\x8a\x80"
            "\x03\x20\x40\x60\x87\x00"
            "\x8a\x40"
            "\x8a\x81"s);
}

TEST(KnownBytes, PngNamesItsCurve) {
  const std::string srgb = encoded("a.png", four_pixels(), Transfer::srgb);
  EXPECT_NE(srgb.find("sRGB"), std::string::npos);
  EXPECT_EQ(srgb.find("gAMA"), std::string::npos);
  const std::string gamma2 = encoded("a.png", four_pixels(), Transfer::gamma2);
  EXPECT_EQ(gamma2.find("sRGB"), std::string::npos);
  EXPECT_NE(gamma2.find("gAMA\x00\x00\xc3\x50"s), std::string::npos) << "50000";
}

TEST(KnownBytes, ExrHasRec709Primaries) {
  const std::string exr = encoded("a.exr", four_pixels(), Transfer::srgb);
  EXPECT_TRUE(exr.starts_with("\x76\x2f\x31\x01"s));
  // 0.64, the x of red, after the attribute's name, type and size.
  const std::string attribute = "chromaticities\0chromaticities\0\x20\0\0\0\x0a\xd7\x23\x3f"s;
  EXPECT_NE(exr.find(attribute), std::string::npos);
}

}  // namespace
}  // namespace dapple
