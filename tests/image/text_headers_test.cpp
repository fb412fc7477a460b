// Files that other programs write: all the variants of PPM, PFM and HDR.
#include <gtest/gtest.h>

#include "image/transfer.h"
#include "tests/image/sample_images.h"

namespace dapple {
namespace {

using namespace std::string_literals;

Image decoded(const std::string& text) {
  auto image = decode_image(to_bytes(text), {Transfer::gamma2});
  EXPECT_TRUE(image) << to_string(image.error());
  return image ? *image : Image();
}

Error error_of(const std::string& text) {
  const auto image = decode_image(to_bytes(text));
  EXPECT_FALSE(image) << text;
  return image ? Error{} : image.error();
}

// With gamma 2.
Vec3f squares(float r, float g, float b) { return {r * r, g * g, b * b}; }

TEST(Ppm, BinaryAndTextOfAnyMaximum) {
  const Image::Pixels expected = {squares(0, 0.5f, 1), squares(1, 0, 0.5f)};
  EXPECT_EQ(decoded("P6\n2 1\n2\n\0\1\2\2\0\1"s).pixels, expected);
  EXPECT_EQ(decoded("P6 2 1 512\n\0\0\1\0\2\0\2\0\0\0\1\0"s).pixels, expected);
  EXPECT_EQ(decoded("P3\n2 1\n4\n0 2 4\n4 0 2\n").pixels, expected);
  EXPECT_EQ(decoded("P3 2 1 4 0 2 4 4 0 2").pixels, expected);
}

TEST(Ppm, GreyFillsAllChannels) {
  const Image::Pixels expected = {squares(0.5f, 0.5f, 0.5f), squares(1, 1, 1)};
  EXPECT_EQ(decoded("P5\n2 1\n2\n\1\2"s).pixels, expected);
  EXPECT_EQ(decoded("P5\n1 2\n512\n\1\0\2\0"s).pixels, expected);
  EXPECT_EQ(decoded("P2\n2 1\n2\n1 2\n").pixels, expected);
}

TEST(Ppm, CommentsAndWhiteSpaceInTheHeader) {
  const Image::Pixels expected = {squares(0.5f, 0, 1)};
  EXPECT_EQ(decoded("P6# by hand\n# more\n 1\t\r\n#5\n1 # one\n2\n\1\0\2"s).pixels, expected);
}

TEST(Ppm, TheRasterMayStartWithSpaceOrCommentCharacters) {
  EXPECT_EQ(decoded("P6\n1 1\n255\n #\n"s).pixels, decoded("P3 1 1 255 32 35 10").pixels);
}

TEST(Ppm, ErrorsNameTheByteAndTheReason) {
  EXPECT_EQ(to_string(error_of("P6\n2 x\n255\n")),
            "byte 5: the height is not an integer from 1 to 2147483647");
  EXPECT_EQ(to_string(error_of("P6\n2 2\n65536\n")),
            "byte 7: the maximum value is not an integer from 1 to 65535");
  EXPECT_EQ(to_string(error_of("P6\n2 2\n255\nabc")),
            "byte 14: the file ends early: 2 x 2 pixels need 23 bytes");
  EXPECT_EQ(to_string(error_of("P6\n1 1\n100\n\x01\x02\xff")),
            "byte 13: a sample is 255, above the maximum 100");
  EXPECT_EQ(to_string(error_of("P3\n1 1\n100\n1 2 101")),
            "byte 15: the sample is not an integer from 0 to 100");
  for (const char* text : {"P6", "P6\n", "P6\n1", "P6\n1 1", "P6\n1 1\n255", "P6\n0 1\n255\n",
                           "P6\n-1 1\n255\n", "P6\n1 1\n0\n\1\1\1", "P3 1 1 9 1 2",
                           "P3 1 1 9 1 2 x", "P6\n1 99999999999\n255\n", "P6\n1 1\n25.5\n\1\1\1"}) {
    EXPECT_EQ(error_of(text).code, Errc::bad_data) << text;
  }
}

TEST(Pfm, BothByteOrdersGreyAndScale) {
  const Image::Pixels expected = {{1, 2, 0.5f}};
  EXPECT_EQ(decoded("PF\n1 1\n-1\n\0\0\x80\x3f\0\0\0\x40\0\0\0\x3f"s).pixels, expected);
  EXPECT_EQ(decoded("PF\n1 1\n1.0\n\x3f\x80\0\0\x40\0\0\0\x3f\0\0\0"s).pixels, expected);
  EXPECT_EQ(decoded("PF 1 1 -0.5\n\0\0\0\x40\0\0\x80\x40\0\0\x80\x3f"s).pixels, expected);
  const Image::Pixels bottom_first = {{2, 2, 2}, {1, 1, 1}};
  EXPECT_EQ(decoded("Pf\n1 2\n-1.000000\n\0\0\x80\x3f\0\0\0\x40"s).pixels, bottom_first);
}

TEST(Pfm, BadHeaders) {
  for (const char* text : {"PF", "PF\n1 1\n0\n............", "PF\n1 1\nnan\n............",
                           "PF\n1 1\n-1x\n............", "PF\n1 1\n", "PF\n1 1\n-1",
                           "PF\n1 1\n-1\n...........", "PF\n0 1\n-1\n............"}) {
    EXPECT_EQ(error_of(text).code, Errc::bad_data) << text;
  }
}

constexpr const char* kHdr = "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n";

TEST(Hdr, FlatPixelsInEveryOrientation) {
  const std::string pixels = "\x80\0\0\x81\0\x80\0\x81\0\0\x80\x81\0\0\0\0"s;
  const Vec3f r{1, 0, 0}, g{0, 1, 0}, b{0, 0, 1}, k{0, 0, 0};
  using Pixels = Image::Pixels;
  EXPECT_EQ(decoded(kHdr + "\n-Y 2 +X 2\n"s + pixels).pixels, (Pixels{r, g, b, k}));
  EXPECT_EQ(decoded(kHdr + "\n-Y 2 -X 2\n"s + pixels).pixels, (Pixels{g, r, k, b}));
  EXPECT_EQ(decoded(kHdr + "\n+Y 2 +X 2\n"s + pixels).pixels, (Pixels{b, k, r, g}));
  EXPECT_EQ(decoded(kHdr + "\n+Y 2 -X 2\n"s + pixels).pixels, (Pixels{k, b, g, r}));
}

TEST(Hdr, ExposuresAreDividedOut) {
  const auto image = decoded(kHdr + "EXPOSURE=4\nEXPOSURE= 0.5\n\n-Y 1 +X 1\n\x80\x40\x20\x82"s);
  EXPECT_EQ(image.pixels, (Image::Pixels{{1, 0.5f, 0.25f}}));
}

TEST(Hdr, OldRunsRepeatThePixelBefore) {
  // One pixel, 3 repetitions, then 2 + 256 * 1 of another.
  const std::string old = "\x80\0\0\x81\1\1\1\3\0\x80\0\x81\1\1\1\2\1\1\1\1"s;
  const Image image = decoded("#?RGBE\n\n-Y 1 +X 263\n" + old);
  ASSERT_EQ(image.width, 263);
  for (int x = 0; x < 263; ++x) {
    EXPECT_EQ(image.at(x, 0), x < 4 ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0)) << x;
  }
}

TEST(Hdr, EncodedRunsAndLiterals) {
  const std::string line =
      "\2\2\0\x09"
      "\x89\x80"
      "\x04\1\2\3\4\x85\0"
      "\x09\0\0\0\0\0\0\0\0\xff"
      "\x89\x81"s;
  const Image image = decoded(kHdr + "\n-Y 1 +X 9\n"s + line);
  EXPECT_EQ(image.at(0, 0), Vec3f(1, 1 / 128.0f, 0));
  EXPECT_EQ(image.at(3, 0), Vec3f(1, 4 / 128.0f, 0));
  EXPECT_EQ(image.at(8, 0), Vec3f(1, 0, 255 / 128.0f));
}

TEST(Hdr, BadFiles) {
  const std::string pixel = "\x80\0\0\x81"s;
  const std::string wide = kHdr + "\n-Y 1 +X 9\n"s;
  for (const std::string& text : {
           "#?RADIANCE"s,
           kHdr + ""s,
           kHdr + "\n"s,
           kHdr + "\n-Y 1 +X 1"s,
           "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + pixel,
           kHdr + "EXPOSURE=0\n\n-Y 1 +X 1\n"s + pixel,
           kHdr + "EXPOSURE=x\n\n-Y 1 +X 1\n"s + pixel,
           kHdr + "\n+X 1 -Y 1\n"s + pixel,
           kHdr + "\n-Y 0 +X 1\n"s + pixel,
           kHdr + "\n-Y 1 +X\n"s + pixel,
           kHdr + "\n-Y\n"s + pixel,
           kHdr + "\n-Y 2 +X 1\n"s + pixel,
           kHdr + "\n-Y 1 +X 3\n\1\1\1\2"s + pixel,               // repeats nothing
           kHdr + "\n-Y 1 +X 3\n"s + pixel + "\1\1\1\3"s,         // repeats too much
           wide + "\2\2\0\x08\x88\0\x88\0\x88\0\x88\0"s,          // another width
           wide + "\2\2\0\x09\x8a\0\x89\0\x89\0\x89\0"s,          // too long a run
           wide + "\2\2\0\x09\x0a..........\x89\0\x89\0\x89\0"s,  // too long a literal
           wide + "\2\2\0\x09\0\0\0\0\0\0\0\0"s,                  // an empty literal
           wide + "\2\2\0\x09\x89\0\x89\0\x89\0\x89"s,            // ends early
       }) {
    EXPECT_EQ(error_of(text).code, Errc::bad_data) << text;
  }
}

}  // namespace
}  // namespace dapple
