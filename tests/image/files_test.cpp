// The table of formats, and the way to and from the disk.
#include <gtest/gtest.h>

#include "image/formats.h"
#include "tests/image/sample_images.h"
#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

using namespace std::string_literals;

TEST(ImageFiles, TheEndingChoosesTheFormatInAnyCase) {
  const TemporaryFolder folder;
  const Image image = random_image(9, 5, 1);
  const auto starts = [&](const std::string& name, const std::string& magic) {
    const std::string path = folder / name;
    EXPECT_TRUE(write_image(path, image, {}));
    EXPECT_TRUE(get_file(path).starts_with(magic)) << name;
  };
  for (const char* name : {"a.png", "a.PNG", "a.b.Png", ".png"}) starts(name, "\x89PNG\r\n\x1a\n");
  for (const char* name : {"a.exr", "a.EXR"}) starts(name, "\x76\x2f\x31\x01");
  for (const char* name : {"a.pfm", "a.Pfm"}) starts(name, "PF\n");
  for (const char* name : {"a.hdr", "a.HDR"}) starts(name, "#?RADIANCE\n");
  for (const char* name : {"a.ppm", "a", "a.jpg", "png", "a.png.", "a.png ", "a.exr.bak"}) {
    starts(name, "P6\n9 5\n255\n");
  }
}

TEST(ImageFiles, TheContentChoosesTheReader) {
  const TemporaryFolder folder;
  const Image image = constant_image(9, 5, {1, 0, 1});
  for (const char* ending : kEndings) {
    ASSERT_TRUE(write_image(folder / ("a"s + ending), image, {}));
    std::filesystem::rename(folder / ("a"s + ending), folder / "picture.txt");
    const auto back = read_image(folder / "picture.txt");
    ASSERT_TRUE(back) << ending << to_string(back.error());
    EXPECT_TRUE(same_bits(*back, image)) << ending;
  }
}

TEST(ImageFiles, ReadingErrorsNameTheFile) {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& name) {
    const auto image = read_image(folder / name);
    EXPECT_FALSE(image) << name;
    return image ? Error{} : image.error();
  };
  put_file(folder / "empty", "");
  put_file(folder / "foreign", "GIF89a");
  put_file(folder / "short.ppm", "P6\n2 2\n255\nabc");
  EXPECT_EQ(error_of("missing").code, Errc::no_input);
  EXPECT_EQ(error_of("").code, Errc::no_input) << "a folder";
  EXPECT_EQ(error_of("empty").code, Errc::bad_data);
  EXPECT_EQ(to_string(error_of("empty")), folder / "empty" + ": the file is empty");
  EXPECT_EQ(to_string(error_of("foreign")),
            folder / "foreign" +
                ": not a picture in a known format (ppm, png, exr, pfm, hdr, jpeg, webp)");
  EXPECT_EQ(to_string(error_of("short.ppm")),
            folder / "short.ppm" + ", byte 14: the file ends early: 2 x 2 pixels need 23 bytes");
}

TEST(ImageFiles, WritingErrorsNameTheFile) {
  const TemporaryFolder folder;
  const Image image = random_image(9, 5, 1);
  for (const char* ending : kEndings) {
    const std::string path = folder / ("missing/a"s + ending);
    const Status status = write_image(path, image, {});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, Errc::cannot_create);
    EXPECT_TRUE(to_string(status.error()).starts_with(path));
  }
  EXPECT_EQ(write_image("/dev/full", image, {}).error().code, Errc::io);
}

TEST(ImageFiles, PicturesWithoutPixelsOrWithTooFewAreNotWritten) {
  const TemporaryFolder folder;
  Image few(3, 3);
  few.pixels.pop_back();
  for (const Image& image : {Image(), Image(0, 5), few}) {
    for (const char* ending : kEndings) {
      const Status status = write_image(folder / ("a"s + ending), image, {});
      ASSERT_FALSE(status);
      EXPECT_EQ(status.error().code, Errc::internal);
    }
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(ImageFiles, PicturesAboveTheLimitAreRefused) {
  const Image image = random_image(10, 10, 1);
  for (const char* ending : kEndings) {
    const auto bytes = encode_image(ending, image, {});
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(decode_image(*bytes, {Transfer::srgb, 100})) << ending;
    const auto refused = decode_image(*bytes, {Transfer::srgb, 99});
    ASSERT_FALSE(refused) << ending;
    EXPECT_EQ(to_string(refused.error()), "10 x 10 pixels are not a picture of 1 to 99 pixels");
  }
}

}  // namespace
}  // namespace dapple
