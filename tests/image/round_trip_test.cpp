// What is written is read back: exactly where the format can, within its step elsewhere.
#include <gtest/gtest.h>
#include <half.h>

#include <algorithm>
#include <cmath>

#include "image/transfer.h"
#include "tests/image/sample_images.h"

namespace dapple {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Size {
  int width, height;
};
// Around the limits of the run-length encoding of HDR (8) and the blocks of EXR (16 lines).
constexpr Size kSizes[] = {{1, 1},  {1, 2},   {2, 1},    {1, 37},  {53, 1},  {7, 5},   {8, 3},
                           {9, 16}, {31, 17}, {128, 33}, {129, 3}, {500, 2}, {3, 300}, {64, 64}};

Image round_trip(const std::string& name, const Image& image, const ImageWriteOptions& options = {},
                 const ImageReadOptions& read_options = {}) {
  const auto bytes = encode_image(name, image, options);
  EXPECT_TRUE(bytes) << to_string(bytes.error());
  auto result = decode_image(*bytes, read_options);
  EXPECT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->width, image.width);
  EXPECT_EQ(result->height, image.height);
  return *result;
}

template <class Check>
void for_each_value(const Image& before, const Image& after, Check check) {
  ASSERT_EQ(before.pixels.size(), after.pixels.size());
  for (std::size_t i = 0; i < before.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) check(before.pixels[i][c], after.pixels[i][c]);
  }
}

TEST(RoundTrip, PfmAndFloatExrKeepEveryBit) {
  ImageWriteOptions options;
  options.exr_float = true;
  std::uint32_t seed = 0;
  for (const Size& size : kSizes) {
    const Image image = random_bits_image(size.width, size.height, ++seed);
    EXPECT_TRUE(same_bits(round_trip("a.pfm", image), image));
    EXPECT_TRUE(same_bits(round_trip("a.exr", image, options), image));
  }
}

TEST(RoundTrip, IntegerFormatsKeepTheNearestStep) {
  std::uint32_t seed = 0;
  for (const Size& size : kSizes) {
    const Image image = random_image(size.width, size.height, ++seed);
    for (const Transfer transfer : {Transfer::srgb, Transfer::gamma2}) {
      for (const int bits : {8, 16}) {
        const ImageWriteOptions options{transfer, bits, false};
        const std::uint32_t max = bits == 8 ? 255 : 65535;
        // The PNG file names its curve; reading as something else would show.
        const ImageReadOptions other{transfer == Transfer::srgb ? Transfer::gamma2
                                                                : Transfer::srgb};
        const Image png = round_trip("a.png", image, options, other);
        for_each_value(image, png, [&](float before, float after) {
          ASSERT_EQ(encode_integer(before, transfer, max), encode_integer(after, transfer, max));
          ASSERT_NEAR(encode_display(before, transfer), encode_display(after, transfer),
                      0.51 / max);
        });
        EXPECT_TRUE(same_bits(round_trip("a.png", png, options), png));
        if (bits == 8) {
          EXPECT_TRUE(same_bits(round_trip("a.ppm", image, options, {transfer}), png));
        }
      }
    }
  }
}

TEST(RoundTrip, HalfExrKeepsTheNearestHalf) {
  std::uint32_t seed = 0;
  for (const Size& size : kSizes) {
    const Image image = random_bits_image(size.width, size.height, ++seed);
    for_each_value(image, round_trip("a.exr", image), [](float before, float after) {
      if (std::isnan(before)) {
        ASSERT_TRUE(std::isnan(after));
      } else if (std::fabs(before) > 65504 && std::isfinite(before)) {
        ASSERT_EQ(after, std::copysign(65504.0f, before));
      } else {
        ASSERT_EQ(after, static_cast<float>(half(before)));
      }
    });
  }
}

TEST(RoundTrip, HdrKeepsAPartIn255OfTheLargestChannel) {
  std::uint32_t seed = 0;
  for (const Size& size : kSizes) {
    const Image image = random_image(size.width, size.height, ++seed);
    const Image hdr = round_trip("a.hdr", image);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const float allowed = max_abs_component(image.pixels[i]) / 255;
      ASSERT_LE(max_abs_component(hdr.pixels[i] - image.pixels[i]), allowed);
    }
    EXPECT_TRUE(same_bits(round_trip("a.hdr", hdr), hdr));
  }
}

TEST(RoundTrip, ValuesThatAFormatCannotHold) {
  const Image odd = [] {
    Image image(10, 2);
    const float values[] = {kNan, -1.0f, -kInfinity, kInfinity, 1e30f, 0.0f};
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      image.pixels[i] = {values[i % 6], values[(i + 1) % 6], values[(i + 2) % 6]};
    }
    return image;
  }();
  const auto dark = [](float value) { return !(value > 0); };
  for (const char* name : {"a.ppm", "a.png"}) {
    for_each_value(odd, round_trip(name, odd), [&](float before, float after) {
      ASSERT_EQ(after, dark(before) ? 0.0f : 1.0f);
    });
  }
  for_each_value(odd, round_trip("a.hdr", odd), [&](float before, float after) {
    if (dark(before)) {
      ASSERT_EQ(after, 0.0f);
    } else if (std::isinf(before)) {
      ASSERT_EQ(after, 255 * 0x1p119f);
    } else {
      ASSERT_TRUE(after == 0.0f || std::fabs(after / before - 1) < 1.0f / 255);
    }
  });
  for_each_value(odd, round_trip("a.exr", odd), [](float before, float after) {
    const float expected = before == 1e30f ? 65504.0f : before;
    ASSERT_TRUE(after == expected || (std::isnan(after) && std::isnan(before)));
  });
}

TEST(RoundTrip, TheSamePictureGivesTheSameBytes) {
  const Image image = random_image(100, 70, 1);
  for (const char* name : kEndings) {
    const Image copy = image;
    EXPECT_EQ(encode_image(name, image, {}).value(), encode_image(name, copy, {}).value()) << name;
  }
}

TEST(RoundTrip, LongFlatLines) {
  for (const int width : {127, 128, 1000, 32767, 32768, 40'000}) {
    const Image image = constant_image(width, 2, {1, 0.5f, 0.25f});
    for (const char* name : {"a.hdr", "a.exr", "a.pfm"}) {
      EXPECT_TRUE(same_bits(round_trip(name, image), image)) << name << " " << width;
    }
  }
}

}  // namespace
}  // namespace dapple
