#include "render/sight.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/render/lit_scenes.h"

namespace dapple {
namespace {

using namespace test;

bool sees(const Scene& scene, int side) {
  RenderSettings settings;
  settings.width = settings.height = side;
  return sees_surfaces(PreparedScene(scene, make_accel(AccelKind::fast, scene)), settings);
}

Scene sphere_at(const Vec3d& centre, double radius) {
  Scene scene = empty_lit_scene(4, 10);
  scene.add_sphere(Sphere{centre, radius}, add_diffuse(scene, 0.5f));
  return scene;
}

TEST(Sight, AnEmptySceneHasNothingToSee) { EXPECT_FALSE(sees(empty_lit_scene(4, 10), 64)); }

TEST(Sight, ShapesAreSeenInThePictureOnly) {
  EXPECT_TRUE(sees(sphere_at({0, 0, 0}, 1), 64));
  EXPECT_FALSE(sees(sphere_at({5, 0, 0}, 1), 64));   // beside it
  EXPECT_FALSE(sees(sphere_at({0, 0, 20}, 1), 64));  // behind the camera
}

TEST(Sight, WhereTheCameraIsFocusedDoesNotMatter) {
  Scene scene = sphere_at({0, 0, 0}, 1);
  scene.camera.orthographic_height = 0;
  scene.camera.focus_distance = 1e6;
  EXPECT_TRUE(sees(scene, 64));
}

TEST(Sight, SmallThingsAreSeenFromNearBy) {
  for (const double size : {1e-3, 1e-4, 1e-8}) {
    Scene scene = sphere_at({0, 0, 0}, size);
    scene.camera.orthographic_height = 0;
    scene.camera.look_from = {0, 0, 4 * size};
    scene.camera.focus_distance = 4 * size;
    EXPECT_TRUE(sees(scene, 64)) << size;
  }
}

TEST(Sight, AShapeAsLargeAsAPixelIsFound) {
  const double pixel = 4.0 / 256;
  EXPECT_TRUE(sees(sphere_at({1.2345, -0.777, 0}, pixel), 256));
}

bool in_medium(const Scene& scene) {
  return stands_in_medium(PreparedScene(scene, make_accel(AccelKind::fast, scene)));
}

// The camera looks from (0, 0, 10).
TEST(Sight, AMediumAroundTheCameraIsNoticed) {
  const auto body = [](const Vec3d& centre, double radius, float attenuation_distance) {
    Scene scene = empty_lit_scene(4, 10);
    LayeredMaterial glass;
    glass.transmission = 1;
    glass.thickness = 1;
    glass.attenuation_distance = attenuation_distance;
    glass.attenuation_colour = {0.5f, 0.5f, 0.5f};
    scene.add_sphere(Sphere{centre, radius}, add_layered(scene, glass));
    scene.add_sphere(Sphere{{0, 0, 8}, 0.5}, add_diffuse(scene, 0.5f));
    return scene;
  };
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(in_medium(body({0, 0, 9}, 3, 1)));
  EXPECT_FALSE(in_medium(body({0, 0, 9}, 3, kInfinity)));  // clear glass
  EXPECT_FALSE(in_medium(body({0, 0, 3}, 3, 1)));          // in front of the camera
  EXPECT_FALSE(in_medium(sphere_at({0, 0, 10}, 3)));
}

TEST(Sight, FromInsideOfAShapeItIsSeen) { EXPECT_TRUE(sees(sphere_at({0, 0, 10}, 3), 32)); }

}  // namespace
}  // namespace dapple
