#include "render/sight.h"

#include <gtest/gtest.h>

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

TEST(Sight, FromInsideOfAShapeItIsSeen) { EXPECT_TRUE(sees(sphere_at({0, 0, 10}, 3), 32)); }

}  // namespace
}  // namespace dapple
