// Damaged files: an error or a picture, never a crash and never memory on the file's word alone.
#include <gtest/gtest.h>

#include "image/formats.h"
#include "tests/image/sample_images.h"

namespace dapple {
namespace {

using namespace std::string_literals;

struct Sample {
  std::string name;
  std::vector<std::byte> bytes;
  Image image;
};

std::vector<Sample> small_samples() {
  std::vector<Sample> samples;
  std::uint32_t seed = 0;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(9, 5), std::pair(17, 20)}) {
    const Image image = random_image(width, height, ++seed);
    for (const char* name : kEndings) {
      for (const bool wide : {false, true}) {
        const ImageWriteOptions options{Transfer::gamma2, wide ? 16 : 8, wide};
        auto bytes = encode_image(name, image, options).value();
        Image decoded = decode_image(bytes).value();
        samples.push_back({name, std::move(bytes), std::move(decoded)});
      }
    }
  }
  for (const std::string& text : std::vector{"P3\n2 2\n255\n1 22 255 4 5 6 7 8 9 10 11 12\n"s,
                                             "#?RGBE\n\n-Y 1 +X 9\n\x80\0\0\x81\1\1\1\x08"s,
                                             "Pf\n1 2\n1.0\n\x3f\x80\0\0\x40\0\0\0"s}) {
    samples.push_back({text.substr(0, 2), to_bytes(text), decode_image(to_bytes(text)).value()});
  }
  return samples;
}

// A file may name any size; a test does not need pictures larger than this.
constexpr ImageReadOptions kLimits{Transfer::srgb, 1 << 20};

void expect_sane(const Expected<Image>& image, const std::string& what) {
  if (image) {
    EXPECT_EQ(image->pixels.size(),
              static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height))
        << what;
  } else {
    EXPECT_EQ(image.error().code, Errc::bad_data) << what << to_string(image.error());
    EXPECT_FALSE(image.error().message.empty()) << what;
  }
}

TEST(BrokenImages, EveryTruncationIsAnErrorOrTheSamePicture) {
  for (const Sample& sample : small_samples()) {
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      // A copy of just this size, so that reading past the end shows.
      const std::vector<std::byte> part(sample.bytes.begin(),
                                        sample.bytes.begin() + static_cast<std::ptrdiff_t>(size));
      const auto image = decode_image(part, kLimits);
      const std::string what = sample.name + " cut at byte " + std::to_string(size);
      expect_sane(image, what);
      // The last sample of a text file is a shorter number then, with nothing to tell.
      if (image && sample.name != "P3") {
        EXPECT_TRUE(same_bits(*image, sample.image)) << what;
      }
    }
  }
}

TEST(BrokenImages, FlippedBitsAreHarmless) {
  for (const Sample& sample : small_samples()) {
    const std::size_t bits = sample.bytes.size() * 8;
    const std::size_t step = 1 + bits / 4000;
    for (std::size_t bit = 0; bit < bits; bit += step) {
      std::vector<std::byte> bytes = sample.bytes;
      bytes[bit / 8] ^= std::byte{1} << (bit % 8);
      expect_sane(decode_image(bytes, kLimits), sample.name + " bit " + std::to_string(bit));
    }
  }
}

TEST(BrokenImages, EveryFlippedBitOfAPngIsAnError) {
  const auto bytes = encode_image("a.png", random_image(9, 5, 1), {Transfer::gamma2}).value();
  for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    std::vector<std::byte> broken = bytes;
    broken[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_FALSE(decode_image(broken, kLimits)) << bit;
  }
}

TEST(BrokenImages, RandomDamageIsHarmless) {
  std::mt19937 random(7);
  for (const Sample& sample : small_samples()) {
    for (int round = 0; round < 200; ++round) {
      std::vector<std::byte> bytes = sample.bytes;
      const std::size_t keep = std::min<std::size_t>(bytes.size(), 4);
      for (std::uint32_t changes = 1 + random() % 8; changes > 0; --changes) {
        if (bytes.size() > keep) {
          bytes[keep + random() % (bytes.size() - keep)] = static_cast<std::byte>(random());
        }
      }
      expect_sane(decode_image(bytes, kLimits), sample.name + " round " + std::to_string(round));
    }
  }
}

// Headers that promise far more than the file has, with the limit of pixels out of the way.
TEST(BrokenImages, PromisedSizesTakeNoMemory) {
  const ImageReadOptions no_limit{Transfer::srgb, ~0ull};
  const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
  std::vector<std::string> files = {
      "P6\n2147483647 2147483647\n65535\nabc",   "P6\n2147483647 1\n255\nabc",
      "P3\n100000 100000\n255\n1 2 3",           "PF\n100000 100000\n-1\nabcdefghijklmnop",
      hdr + "-Y 100000 +X 100000\n\2\2\x7f\xff", hdr + "-Y 1 +X 2147483647\nabcdefgh"};
  for (const std::string& file : files) {
    const auto image = decode_image(to_bytes(file), no_limit);
    ASSERT_FALSE(image) << file;
    EXPECT_EQ(image.error().code, Errc::bad_data) << file;
  }
}

// The same for PNG and EXR, whose sizes stand at fixed places.
TEST(BrokenImages, PromisedSizesOfBinaryHeadersTakeNoMemory) {
  const ImageReadOptions no_limit{Transfer::srgb, ~0ull};
  const Image image = random_image(9, 5, 1);
  std::vector<std::byte> exr = encode_image("a.exr", image, {}).value();
  const std::string text = to_text(exr);
  const std::size_t window = text.find("dataWindow\0box2i\0"s) + 17 + 4;
  for (const std::size_t corner : {window + 8, window + 12}) {
    exr[corner + 2] = std::byte{0xff};  // 16 million columns or lines
  }
  EXPECT_FALSE(decode_image(exr, no_limit));
}

}  // namespace
}  // namespace dapple
