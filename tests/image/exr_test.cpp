// EXR files that other programs write, made here with OpenEXR in a folder of their own.
#include <ImfChannelList.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfPreviewImage.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>
#include <ImfTiledOutputFile.h>
#include <ImfTimeCodeAttribute.h>
#include <gtest/gtest.h>
#include <half.h>

#include "image/formats.h"
#include "tests/image/sample_images.h"
#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

constexpr const char* kChannels[3] = {"R", "G", "B"};

// Values that half, float and unsigned integers all hold.
Image whole_numbers(int width, int height) {
  Image image(width, height);
  float value = 0;
  for (Vec3f& pixel : image.pixels) {
    for (int c = 0; c < 3; ++c) pixel[c] = value = value < 2000 ? value + 1 : 0;
  }
  return image;
}

Imf::FrameBuffer frame_of(const Image& image, const Imf::Header& header, int channels,
                          const char* const* names) {
  Imf::FrameBuffer frame;
  for (int c = 0; c < channels; ++c) {
    auto* base = const_cast<float*>(&image.pixels[0].x) + c;
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, base, header.dataWindow(), sizeof(Vec3f),
                                            sizeof(Vec3f) * static_cast<std::size_t>(image.width)));
  }
  return frame;
}

void write_lines(const std::string& path, const Image& image, const Imf::Header& header,
                 int channels, const char* const* names) {
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame_of(image, header, channels, names));
  file.writePixels(image.height);
}

class ExrTest : public testing::Test {
 protected:
  Imf::Header header_for(const Image& image, int channels = 3,
                         const char* const* names = kChannels) const {
    Imf::Header header(image.width, image.height);
    for (int c = 0; c < channels; ++c) header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    return header;
  }

  Image read() const {
    auto image = read_image(path);
    EXPECT_TRUE(image) << to_string(image.error());
    return image ? *image : Image();
  }

  TemporaryFolder folder;
  std::string path = folder / "picture";
};

TEST_F(ExrTest, EveryLosslessCompressionReadsTheSame) {
  const Image image = whole_numbers(37, 70);
  for (const Imf::Compression compression :
       {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
        Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
    Imf::Header header = header_for(image);
    header.compression() = compression;
    write_lines(path, image, header, 3, kChannels);
    EXPECT_TRUE(same_bits(read(), image)) << compression;
  }
}

TEST_F(ExrTest, LossyCompressionsRead) {
  const Image image = constant_image(65, 300, {1, 0.5f, 0.25f});
  for (const Imf::Compression compression : {Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION,
                                             Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
    Imf::Header header = header_for(image);
    header.compression() = compression;
    write_lines(path, image, header, 3, kChannels);
    const Image back = read();
    ASSERT_EQ(back.pixels.size(), image.pixels.size());
    for (const Vec3f& pixel : back.pixels) {
      ASSERT_LT(max_abs_component(pixel - image.pixels[0]), 0.02f) << compression;
    }
  }
}

TEST_F(ExrTest, TilesAndTheirLevels) {
  const Image image = whole_numbers(45, 33);
  for (const Imf::LevelMode mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS}) {
    Imf::Header header = header_for(image);
    header.setTileDescription(Imf::TileDescription(16, 8, mode));
    {
      Imf::TiledOutputFile file(path.c_str(), header);
      file.setFrameBuffer(frame_of(image, header, 3, kChannels));
      for (int level = 0; level < file.numLevels(); ++level) {
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
      }
    }
    EXPECT_TRUE(same_bits(read(), image));
  }
}

TEST_F(ExrTest, TheDataWindowMayLieAnywhere) {
  const Image image = whole_numbers(5, 4);
  Imf::Header header = header_for(image);
  header.dataWindow() = {{-7, 1000}, {-3, 1003}};
  write_lines(path, image, header, 3, kChannels);
  EXPECT_TRUE(same_bits(read(), image));
}

TEST_F(ExrTest, LuminanceIsGreyAndMissingColoursAreBlack) {
  const Image image = whole_numbers(5, 4);
  constexpr const char* kLuminance[] = {"Y"};
  write_lines(path, image, header_for(image, 1, kLuminance), 1, kLuminance);
  const Image grey = read();
  constexpr const char* kRedAndMore[] = {"R", "A", "Z"};
  write_lines(path, image, header_for(image, 3, kRedAndMore), 3, kRedAndMore);
  const Image red = read();
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float value = image.pixels[i].x;
    EXPECT_EQ(grey.pixels[i], Vec3f(value, value, value));
    EXPECT_EQ(red.pixels[i], Vec3f(value, 0, 0));
  }
}

TEST_F(ExrTest, FilesWithoutColourNameTheirChannels) {
  const Image image = whole_numbers(2, 2);
  constexpr const char* kDepth[] = {"Z", "left.R"};
  write_lines(path, image, header_for(image, 2, kDepth), 2, kDepth);
  const auto result = read_image(path);
  ASSERT_FALSE(result);
  EXPECT_EQ(to_string(result.error()), path + ": no channel R, G, B or Y among: Z left.R");
}

TEST_F(ExrTest, AttributesOfEveryKindAreAccepted) {
  const Image image = whole_numbers(4, 3);
  Imf::Header header = header_for(image);
  header.insert("comments", Imf::StringAttribute("made by a test"));
  header.insert("lines", Imf::StringVectorAttribute({"one", "", "three"}));
  header.insert("numbers", Imf::FloatVectorAttribute({1.0f, 2.0f}));
  header.insert("matrix", Imf::M44fAttribute());
  header.insert("time", Imf::TimeCodeAttribute());
  header.setPreviewImage(Imf::PreviewImage(3, 2));
  write_lines(path, image, header, 3, kChannels);
  EXPECT_TRUE(same_bits(read(), image));
}

// OpenEXR reads a list of channels up to its end, whatever size the attribute has.
TEST_F(ExrTest, AttributesWithAWrongSizeAreAnError) {
  const Image image = whole_numbers(4, 3);
  write_lines(path, image, header_for(image), 3, kChannels);
  const std::string good = get_file(path);
  const std::string attribute("channels\0chlist\0", 16);
  const std::size_t size = good.find(attribute) + attribute.size();
  for (const int change : {-19, -18, -1, 1, 2, 127}) {
    std::string broken = good;
    broken[size] = static_cast<char>(broken[size] + change);
    const auto result = decode_image(to_bytes(broken));
    ASSERT_FALSE(result) << change;
    EXPECT_TRUE(result.error().place.starts_with("byte ")) << to_string(result.error());
  }
}

// What we write, read by OpenEXR itself.
TEST_F(ExrTest, OurFilesReadElsewhere) {
  const Image image = whole_numbers(37, 19);
  for (const bool exr_float : {false, true}) {
    const std::string file_name = path + ".exr";
    ASSERT_TRUE(write_image(file_name, image, {Transfer::srgb, 8, exr_float}));
    Imf::InputFile file(file_name.c_str());
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    for (const char* name : kChannels) {
      const Imf::Channel* channel = file.header().channels().findChannel(name);
      ASSERT_NE(channel, nullptr);
      EXPECT_EQ(channel->type, exr_float ? Imf::FLOAT : Imf::HALF);
    }
    Image back(37, 19);
    file.setFrameBuffer(frame_of(back, file.header(), 3, kChannels));
    file.readPixels(0, 18);
    EXPECT_TRUE(same_bits(back, image));
  }
}

}  // namespace
}  // namespace dapple
