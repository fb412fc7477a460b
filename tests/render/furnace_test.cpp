// White furnace on whole pictures. The blue of the sky is 1 in every direction, and so is what is
// cut: in blue, whatever absorbs nothing is invisible.
#include <gtest/gtest.h>

#include <cmath>

#include "render/classic_paths.h"
#include "render/render_job.h"
#include "tests/scenes/picture_scenes.h"

namespace dapple::test {
namespace {

constexpr double kRounding = 0x1p-20;  // of (1 - t) + t and of products of ones

Image picture(const Scene& scene) {
  RenderSettings settings;
  settings.width = 48;
  settings.height = 36;
  settings.samples_per_pixel = 30;
  const PreparedScene prepared(scene, make_accel(AccelKind::fast, scene));
  const auto result = render(prepared, settings);
  EXPECT_TRUE(result);
  EXPECT_EQ(result->dropped_samples, 0u);
  return result->image;
}

Scene with_all_materials(Scene scene, const Material& material) {
  for (Material& m : scene.materials) m = material;
  return scene;
}

TEST(PictureFurnace, TheBlueOfTheSkyIsOne) {
  for (const Vec3f d : {Vec3f(0, 1, 0), Vec3f(0, -1, 0), Vec3f(3, 0.1f, -7), Vec3f(0, 0, 1e-3f)}) {
    EXPECT_NEAR(sky(d).z, 1, kRounding);
  }
}

TEST(PictureFurnace, WhatAbsorbsNothingIsInvisible) {
  const Material lossless[] = {Lambertian{{1, 1, 1}}, Metal{{1, 1, 1}, 0}, Dielectric{1.5},
                               Dielectric{0.6}};
  for (const PictureScene& scene : picture_scenes()) {
    for (const Material& material : lossless) {
      const Image image = picture(with_all_materials(scene.scene, material));
      for (const Vec3f& pixel : image.pixels) ASSERT_NEAR(pixel.z, 1, kRounding) << scene.name;
    }
  }
}

// Inside a closed body of albedo a every path is cut, after five scatterings: a^5.
TEST(PictureFurnace, AClosedRoomIsThePowerOfItsAlbedo) {
  Scene scene;
  const double albedo = 0.75;
  const Material materials[] = {Lambertian{{albedo, 1, albedo}}, Metal{{albedo, 1, albedo}, 0}};
  for (const Material& material : materials) {
    scene = {};
    scene.camera.look_from = {0.2, 0.1, 0.3};
    scene.add_sphere({{0, 0, 0}, 2}, scene.add_material(material));
    const Image image = picture(scene);
    for (const Vec3f& pixel : image.pixels) {
      ASSERT_NEAR(pixel.x, std::pow(albedo, 5), kRounding);
      ASSERT_NEAR(pixel.y, 1, kRounding);
    }
  }
}

// A closed room of six rectangles leaks no light through its edges: every path ends by being cut.
TEST(PictureFurnace, ARoomOfRectanglesDoesNotLeak) {
  Scene scene;
  scene.camera.look_from = {0.2, 0.1, 0.3};
  const MaterialId black = scene.add_material(Lambertian{{0, 0, 0}});
  for (std::size_t kind = 0; kind < kRectangleKindCount; ++kind) {
    for (const double k : {-1.0, 1.0}) {
      scene.add_rectangle(rectangle_kind(kind), {-1, 1, -1, 1, k}, black);
    }
  }
  for (const Vec3f& pixel : picture(scene).pixels) ASSERT_EQ(pixel, Vec3f(0, 0, 0));
}

// Overflow on the way to the film: an albedo of 1e30 squared is infinite in single precision.
TEST(PictureFurnace, PathsThatOverflowAreDroppedAndCounted) {
  Scene scene;
  scene.camera.look_from = {0, 0, 1};
  scene.add_sphere({{0, 0, 0}, 3}, scene.add_material(Lambertian{{1e30, 1, 1}}));
  RenderSettings settings;
  settings.width = settings.height = 5;
  settings.samples_per_pixel = 7;
  const PreparedScene prepared(scene, make_accel(AccelKind::fast, scene));
  const auto result = render(prepared, settings);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->dropped_samples, 5u * 5 * 7);
  for (const Vec3f& pixel : result->image.pixels) EXPECT_EQ(pixel, Vec3f(0, 0, 0));
}

// In number of scatterings 1 the camera's ray scatters once and is cut.
TEST(PictureFurnace, TheNumberOfScatteringsIsHonoured) {
  Scene scene;
  scene.camera.look_from = {0, 0, 1};
  scene.add_sphere({{0, 0, 0}, 3}, scene.add_material(Lambertian{{0.5, 0.5, 0.5}}));
  const PreparedScene prepared(scene, make_accel(AccelKind::fast, scene));
  for (const int most : {1, 2, 3, 7}) {
    RenderSettings settings;
    settings.width = settings.height = 4;
    settings.samples_per_pixel = 4;
    settings.max_scatterings = most;
    const auto result = render(prepared, settings);
    ASSERT_TRUE(result);
    for (const Vec3f& pixel : result->image.pixels) {
      EXPECT_NEAR(pixel.x, std::pow(0.5, most), kRounding);
    }
  }
}

}  // namespace
}  // namespace dapple::test
