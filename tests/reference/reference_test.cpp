// The oracle against pictures whose expectation has a closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/reference_tracer.h"

namespace dapple::test {
namespace {

double standard_error(const PictureStatistics& picture, std::size_t pixel, std::size_t channel) {
  return std::sqrt(picture.variance(pixel, channel)) + 1e-12;
}

// Under a white sky a closed room of albedo a, cut to white after five scatterings, is a^5; a
// single convex body in the open is a.
TEST(Reference, ConvexBodyUnderAWhiteSkyShowsItsAlbedo) {
  Scene scene;
  scene.add_sphere({{0, 0, -5}, 4}, scene.add_material(Lambertian{{0.25, 0.5, 1}}));
  ReferenceSettings settings;
  settings.width = settings.height = 1;
  scene.camera.vertical_fov = 10;
  settings.sky_above = {1, 1, 1};
  const PictureStatistics picture = reference_picture(scene, settings);
  EXPECT_NEAR(picture.mean(0, 0), 0.25, 1e-12);
  EXPECT_NEAR(picture.mean(0, 1), 0.5, 1e-12);
  EXPECT_NEAR(picture.mean(0, 2), 1, 1e-12);
}

TEST(Reference, ClosedRoomIsThePowerOfItsAlbedo) {
  Scene scene;
  scene.add_sphere({{0, 0, 0}, 4}, scene.add_material(Lambertian{{0.25, 0.5, 1}}));
  ReferenceSettings settings;
  settings.width = settings.height = 2;
  const PictureStatistics picture = reference_picture(scene, settings);
  EXPECT_NEAR(picture.mean(0, 0), std::pow(0.25, 5), 1e-12);
  EXPECT_NEAR(picture.mean(3, 1), std::pow(0.5, 5), 1e-12);
}

// A matt floor sees the sky t = (cos + 1) / 2 with density cos / pi: t is 5/6 on average.
TEST(Reference, MattFloorShowsTheCosineMeanOfTheSky) {
  Scene scene;
  scene.camera.look_from = {0, 5, 0};
  scene.camera.look_at = {0, 0, -5};
  scene.add_rectangle(ShapeKind::xz_rectangle, {-1e6, 1e6, -1e6, 1e6, 0},
                      scene.add_material(Lambertian{{0.8, 0.8, 0.8}}));
  ReferenceSettings settings;
  settings.width = settings.height = 1;
  settings.samples = 100'000;
  scene.camera.vertical_fov = 20;
  const PictureStatistics picture = reference_picture(scene, settings);
  EXPECT_NEAR(picture.mean(0, 0), 0.8 * (1 - 0.5 * 5 / 6), 4 * standard_error(picture, 0, 0));
  EXPECT_NEAR(picture.mean(0, 1), 0.8 * (1 - 0.3 * 5 / 6), 4 * standard_error(picture, 0, 1));
}

TEST(Reference, TheTopOfThePictureIsTheTopOfTheScene) {
  Scene scene;  // looks along -z, horizontally
  ReferenceSettings settings;
  const PictureStatistics picture = reference_picture(scene, settings);
  EXPECT_LT(picture.mean(0, 0), picture.mean(picture.pixel_count() - 1, 0));
}

}  // namespace
}  // namespace dapple::test
