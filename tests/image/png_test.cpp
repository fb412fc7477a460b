// PNG files that other programs write, made here with libpng.
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <functional>

#include "image/transfer.h"
#include "tests/image/sample_images.h"

namespace dapple {
namespace {

struct PngLayout {
  int color_type = PNG_COLOR_TYPE_RGB;
  int bits = 8;
  int interlace = PNG_INTERLACE_NONE;
  std::function<void(png_structp, png_infop)> add_chunks = [](png_structp, png_infop) {};
};

void append_bytes(png_structp png, png_bytep data, std::size_t size) {
  auto* out = static_cast<std::string*>(png_get_io_ptr(png));
  out->append(reinterpret_cast<const char*>(data), size);
}

// Rows of packed samples, as PNG stores them.
std::string make_png(int width, const std::vector<std::vector<png_byte>>& rows,
                     const PngLayout& layout) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &out, append_bytes, [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(rows.size()),
               layout.bits, layout.color_type, layout.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  layout.add_chunks(png, info);
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (const auto& row : rows) pointers.push_back(const_cast<png_bytep>(row.data()));
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

Image::Pixels decoded(const std::string& file) {
  const auto image = decode_image(to_bytes(file), {Transfer::gamma2});
  EXPECT_TRUE(image) << to_string(image.error());
  return image ? image->pixels : Image::Pixels();
}

// Gamma 2 is the curve that decoded() assumes for files that do not name theirs.
Vec3f linear(int r, int g, int b, int max = 255) {
  const std::vector<float> table = decode_table(static_cast<std::uint32_t>(max), Transfer::gamma2);
  const auto value = [&](int i) { return table[static_cast<std::size_t>(i)]; };
  return {value(r), value(g), value(b)};
}

using Pixels = Image::Pixels;

TEST(Png, EveryColourTypeAndDepth) {
  const auto make = [](int color_type, int bits, const std::vector<png_byte>& row) {
    return decoded(make_png(2, {row}, {color_type, bits}));
  };
  EXPECT_EQ(make(PNG_COLOR_TYPE_RGB, 8, {1, 2, 3, 4, 5, 6}),
            (Pixels{linear(1, 2, 3), linear(4, 5, 6)}));
  EXPECT_EQ(make(PNG_COLOR_TYPE_RGBA, 8, {1, 2, 3, 0, 4, 5, 6, 99}),
            (Pixels{linear(1, 2, 3), linear(4, 5, 6)}));
  EXPECT_EQ(make(PNG_COLOR_TYPE_GRAY, 8, {9, 200}),
            (Pixels{linear(9, 9, 9), linear(200, 200, 200)}));
  EXPECT_EQ(make(PNG_COLOR_TYPE_GRAY_ALPHA, 8, {9, 0, 200, 7}),
            (Pixels{linear(9, 9, 9), linear(200, 200, 200)}));
  EXPECT_EQ(make(PNG_COLOR_TYPE_GRAY, 1, {0x40}), (Pixels{linear(0, 0, 0), linear(255, 255, 255)}));
  EXPECT_EQ(make(PNG_COLOR_TYPE_GRAY, 2, {0x60}), (Pixels{linear(1, 1, 1, 3), linear(2, 2, 2, 3)}));
  EXPECT_EQ(make(PNG_COLOR_TYPE_GRAY, 4, {0x1e}),
            (Pixels{linear(1, 1, 1, 15), linear(14, 14, 14, 15)}));
  EXPECT_EQ(make(PNG_COLOR_TYPE_GRAY, 16, {1, 2, 3, 4}),
            (Pixels{linear(258, 258, 258, 65535), linear(772, 772, 772, 65535)}));
  EXPECT_EQ(make(PNG_COLOR_TYPE_RGB, 16, {0, 1, 0, 2, 0, 3, 1, 0, 2, 0, 3, 0}),
            (Pixels{linear(1, 2, 3, 65535), linear(256, 512, 768, 65535)}));
}

TEST(Png, PalettesOfEveryDepthWithAndWithoutTransparency) {
  for (const int bits : {1, 2, 4, 8}) {
    for (const bool transparent : {false, true}) {
      PngLayout layout{PNG_COLOR_TYPE_PALETTE, bits};
      layout.add_chunks = [=](png_structp png, png_infop info) {
        const png_color palette[2] = {{10, 20, 30}, {40, 50, 60}};
        png_set_PLTE(png, info, palette, 2);
        const png_byte alpha[1] = {0};
        if (transparent) png_set_tRNS(png, info, alpha, 1, nullptr);
      };
      const auto first = static_cast<png_byte>(bits == 8 ? 1 : 1 << (8 - bits));
      EXPECT_EQ(decoded(make_png(2, {{first, 0}}, layout)),
                (Pixels{linear(40, 50, 60), linear(10, 20, 30)}));
    }
  }
}

TEST(Png, InterlacedPicturesReadTheSame) {
  std::vector<std::vector<png_byte>> rows(11, std::vector<png_byte>(13 * 3));
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      rows[y][x] = static_cast<png_byte>(x * 7 + y * 31);
    }
  }
  const Pixels plain = decoded(make_png(13, rows, {}));
  const Pixels interlaced =
      decoded(make_png(13, rows, {PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_ADAM7}));
  EXPECT_EQ(plain.size(), 143u);
  EXPECT_EQ(plain, interlaced);
}

Vec3f mid_grey_with(const std::function<void(png_structp, png_infop)>& add_chunks) {
  PngLayout layout;
  layout.add_chunks = add_chunks;
  return decoded(make_png(1, {{128, 128, 128}}, layout)).at(0);
}

TEST(Png, ChunksOfTheCurveAreHonoured) {
  const double display = 128 / 255.0;
  const auto with_gamma = [](double gamma) {
    return mid_grey_with([=](png_structp png, png_infop info) { png_set_gAMA(png, info, gamma); });
  };
  EXPECT_EQ(mid_grey_with([](png_structp, png_infop) {}), linear(128, 128, 128)) << "untagged";
  EXPECT_NEAR(with_gamma(1.0).x, display, 1e-7);
  EXPECT_EQ(with_gamma(0.5), linear(128, 128, 128));
  EXPECT_NEAR(with_gamma(0.45455).x, std::pow(display, 1 / 0.45455), 1e-7);
  const Vec3f srgb = mid_grey_with([](png_structp png, png_infop info) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_RELATIVE);
  });
  EXPECT_EQ(srgb.x, static_cast<float>(decode_display(display, Transfer::srgb)));
}

TEST(Png, LongTextIsSkipped) {
  const std::string long_text(9'000'000, 'x');
  for (const int compression : {PNG_TEXT_COMPRESSION_NONE, PNG_TEXT_COMPRESSION_zTXt}) {
    const Vec3f grey = mid_grey_with([&](png_structp png, png_infop info) {
      png_text text{};
      text.compression = compression;
      text.key = const_cast<char*>("Comment");
      text.text = const_cast<char*>(long_text.c_str());
      text.text_length = long_text.size();
      png_set_text(png, info, &text, 1);
    });
    EXPECT_EQ(grey, linear(128, 128, 128));
  }
}

// One line of a picture that would take 40 GB.
TEST(Png, APromisedSizeTakesNoMemory) {
  constexpr png_uint_32 kSide = 60'000;
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &file, append_bytes, [](png_structp) {});
  png_set_IHDR(png, info, kSide, kSide, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_buffer_size(png, 64);  // so that pixels leave it at all
  png_write_info(png, info);
  png_write_row(png, std::vector<png_byte>(kSide * 3).data());
  png_write_flush(png);
  png_destroy_write_struct(&png, &info);
  const auto image = decode_image(to_bytes(file), {Transfer::srgb, ~0ull});
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, Errc::bad_data);
  EXPECT_NE(image.error().message.find("60000 x 60000 pixels need"), std::string::npos)
      << to_string(image.error());
}

TEST(Png, DamageIsAnErrorThatNamesTheByte) {
  std::string file = make_png(2, {{1, 2, 3, 4, 5, 6}}, {});
  file.resize(file.size() - 20);
  const auto image = decode_image(to_bytes(file));
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, Errc::bad_data);
  EXPECT_TRUE(image.error().place.starts_with("byte ")) << to_string(image.error());
  EXPECT_TRUE(image.error().message.starts_with("damaged PNG: ")) << to_string(image.error());
}

TEST(Png, OtherDepthsCannotBeWritten) {
  for (const int bits : {0, 1, 12, 32}) {
    const auto bytes = encode_image("a.png", constant_image(1, 1, {}), {Transfer::srgb, bits});
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().code, Errc::usage);
  }
}

}  // namespace
}  // namespace dapple
