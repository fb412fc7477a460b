#include "shading/texture_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "image/transfer.h"
#include "math/random.h"
#include "scene/scene.h"

namespace dapple::test {
namespace {

// A scene with one material that uses one image as `use`.
class PaintedScene {
 public:
  PaintedScene(std::uint32_t width, std::uint32_t height, TexelFormat format, MapUse use)
      : use_(use) {
    scene_.images.push_back({width, height, format, 0, 0});
    scene_.texels.resize(scene_.images[0].bytes());
    scene_.textures.push_back({.image = ImageId{0}});
    scene_.layered_materials.emplace_back();
    slot().texture = TextureId{0};
  }

  std::vector<std::uint8_t>& bytes() { return scene_.texels; }
  Texture& texture() { return scene_.textures[0]; }
  TextureSlot& slot() { return scene_.layered_materials[0].map(use_); }

  // `cone` in texture space.
  Vec4f lookup(float u, float v, float cone = 0) {
    SurfaceInteraction at;
    at.uvs[0] = {u, v};
    at.uv_per_length[0] = 1;
    at.cone_width = cone;
    return TextureSet(scene_).lookup(slot(), use_, at);
  }

 private:
  Scene scene_;
  MapUse use_;
};

// Texel (x, y) holds x + 4 y in red.
PaintedScene numbered() {
  PaintedScene scene(4, 3, TexelFormat::rgba8, MapUse::transmission);
  for (std::size_t i = 0; i < 12; ++i) scene.bytes()[4 * i] = static_cast<std::uint8_t>(i);
  return scene;
}

float red_of_texel(PaintedScene& scene, int x, int y) {
  return 255 *
         scene.lookup((static_cast<float>(x) + 0.5f) / 4, (static_cast<float>(y) + 0.5f) / 3).x;
}

TEST(TextureSet, TexelCentresHaveTheTexelsValue) {
  PaintedScene scene = numbered();
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) EXPECT_NEAR(red_of_texel(scene, x, y), x + 4 * y, 1e-4);
  }
}

TEST(TextureSet, WrapsAsAsked) {
  PaintedScene scene = numbered();
  scene.texture().wrap_u = Wrap::repeat;
  scene.texture().wrap_v = Wrap::mirrored_repeat;
  EXPECT_NEAR(red_of_texel(scene, 4, 0), 0, 1e-3);
  EXPECT_NEAR(red_of_texel(scene, -1, 0), 3, 1e-3);
  EXPECT_NEAR(red_of_texel(scene, -9, 0), 3, 1e-3);
  EXPECT_NEAR(red_of_texel(scene, 0, 3), 8, 1e-3);
  EXPECT_NEAR(red_of_texel(scene, 0, -2), 4, 1e-3);
  EXPECT_NEAR(red_of_texel(scene, 0, 6), 0, 1e-3);
  scene.texture().wrap_u = scene.texture().wrap_v = Wrap::clamp_to_edge;
  EXPECT_NEAR(red_of_texel(scene, 9, 9), 11, 1e-3);
  EXPECT_NEAR(red_of_texel(scene, -5, 1), 4, 1e-3);
}

TEST(TextureSet, NearestTakesTheTexelAroundThePoint) {
  PaintedScene scene = numbered();
  scene.texture().filter = Filter::nearest;
  EXPECT_NEAR(255 * scene.lookup(0.499f, 0.01f).x, 1, 1e-4);
  EXPECT_NEAR(255 * scene.lookup(0.501f, 0.01f).x, 2, 1e-4);
}

TEST(TextureSet, LinearIsTheMeanBetweenTexels) {
  PaintedScene scene = numbered();
  EXPECT_NEAR(255 * scene.lookup(0.5f, 0.5f / 3).x, 1.5, 1e-4);
  EXPECT_NEAR(255 * scene.lookup(0.5f, 1.0f / 3).x, 3.5, 1e-4);
}

TEST(TextureSet, SlotsMoveCoordinates) {
  PaintedScene scene = numbered();
  scene.slot().to_uv[0][0] = 0;
  scene.slot().to_uv[0][1] = 1;
  scene.slot().to_uv[1][0] = 1;
  scene.slot().to_uv[1][1] = 0;
  scene.slot().to_uv[1][2] = 1.0f / 3;
  EXPECT_NEAR(255 * scene.lookup(0.5f / 3, 2.5f / 4).x, 2 + 4, 1e-3);
}

TEST(TextureSet, CoordinatesThatAreNoNumbersAreHarmless) {
  PaintedScene scene = numbered();
  for (const float bad : {NAN, INFINITY, -INFINITY, 1e30f}) {
    EXPECT_TRUE(std::isfinite(scene.lookup(bad, bad).x));
  }
}

TEST(TextureSet, ColourIsDecodedFromSrgb) {
  PaintedScene scene(1, 1, TexelFormat::rgba8, MapUse::base_colour);
  scene.bytes() = {0, 128, 255, 128};
  const Vec4f found = scene.lookup(0.3f, 0.8f);
  EXPECT_EQ(found.x, 0);
  EXPECT_NEAR(found.y, decode_display(128 / 255.0, Transfer::srgb), 1e-6);
  EXPECT_NEAR(found.z, 1, 1e-6);
  EXPECT_NEAR(found.w, 128 / 255.0, 1e-6);
}

TEST(TextureSet, FloatsAndWordsAreReadAsTheyStand) {
  PaintedScene floats(1, 1, TexelFormat::rgb32f, MapUse::emissive);
  const float value[3] = {2.5f, -1, 1e6f};
  std::memcpy(floats.bytes().data(), value, sizeof(value));
  EXPECT_EQ(floats.lookup(0, 0), (Vec4f{2.5f, -1, 1e6f, 1}));
  PaintedScene words(1, 1, TexelFormat::rgba16, MapUse::normal);
  const std::uint16_t word[4] = {0, 0x8000, 0xffff, 1};
  std::memcpy(words.bytes().data(), word, sizeof(word));
  EXPECT_NEAR(words.lookup(0, 0).y, 32768.0 / 65535, 1e-7);
}

// Every mip level of any size has the image's mean.
TEST(TextureSet, MipLevelsKeepTheMean) {
  for (const auto& [width, height] : {std::pair{64u, 64u}, {37u, 21u}, {1u, 9u}, {100u, 3u}}) {
    PaintedScene scene(width, height, TexelFormat::rgb32f, MapUse::emissive);
    std::vector<float> values(std::size_t{3} * width * height);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = uniform4(static_cast<std::uint32_t>(i), 0, 0, 0, 1)[0];
      sum += values[i];
    }
    std::memcpy(scene.bytes().data(), values.data(), 4 * values.size());
    const Vec4f coarsest = scene.lookup(0.2f, 0.9f, 1e3f);
    EXPECT_NEAR((coarsest.x + coarsest.y + coarsest.z) / 3,
                sum / static_cast<double>(values.size()), 1e-5)
        << width << " x " << height;
  }
}

// Black and white texels average to half the light, not to half the code.
TEST(TextureSet, MipLevelsAreMadeInLinearLight) {
  PaintedScene scene(16, 16, TexelFormat::rgba8, MapUse::base_colour);
  for (std::size_t i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>((i + i / 16) % 2 == 0 ? 0 : 255);
    for (std::size_t c = 0; c < 4; ++c) scene.bytes()[4 * i + c] = code;
  }
  const Vec4f found = scene.lookup(0.4f, 0.4f, 1);
  EXPECT_NEAR(found.x, 0.5, 0.01);
  EXPECT_NEAR(found.w, 0.5, 0.01);
}

// A cone as wide as a texel shows what is there; wider ones blur more and more.
TEST(TextureSet, WiderConesSeeLessContrast) {
  PaintedScene scene(64, 64, TexelFormat::rgba8, MapUse::transmission);
  for (std::size_t i = 0; i < 64 * 64; ++i) {
    scene.bytes()[4 * i] = uniform4(static_cast<std::uint32_t>(i), 0, 0, 0, 2)[0] < 0.5f ? 0 : 255;
  }
  float before = 1.01f;
  for (const float cone : {1.0f / 64, 1.0f / 8, 1.0f / 2}) {
    float contrast = 0;
    for (int i = 0; i < 64; ++i) {
      const float at = (static_cast<float>(i) + 0.5f) / 64;
      contrast += std::fabs(scene.lookup(at, at, cone).x - 0.5f) / 32;
    }
    EXPECT_LT(contrast, before);
    before = 0.7f * contrast;
  }
}

}  // namespace
}  // namespace dapple::test
