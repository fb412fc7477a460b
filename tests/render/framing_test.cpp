#include "render/framing.h"

#include <gtest/gtest.h>

#include "render/camera_rays.h"

namespace dapple {
namespace {

RenderSettings picture(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  return settings;
}

// Where a point appears, in pictures' widths and heights from the centre: inside when both are
// within half.
struct Place {
  double x, y;
};
Place project(const Camera& camera, double width_over_height, const Vec3d& point) {
  const Vec3d w = normalize(camera.look_from - camera.look_at);
  const Vec3d u = normalize(cross(camera.up, w));
  const Vec3d v = cross(w, u);
  const Vec3d from = point - camera.look_from;
  const double depth = -dot(from, w);
  const double height = 2 * depth * std::tan(camera.vertical_fov * 3.14159265358979 / 360);
  return {dot(from, u) / (height * width_over_height), dot(from, v) / height};
}

TEST(Framing, TheWholeBoxIsSeenAndFillsThePicture) {
  const Bounds3f boxes[] = {{{-1, -1, -1}, {1, 1, 1}},
                            {{100, 0, 0}, {101, 50, 2}},
                            {{-3e-4f, 0, 0}, {3e-4f, 1e-4f, 9e-4f}},
                            {{0, 0, 0}, {1e6f, 1, 1}}};
  for (const Bounds3f& box : boxes) {
    for (const double aspect : {0.3, 1.0, 2.5}) {
      const Camera camera = frame_scene(box, aspect);
      double farthest = 0;
      for (int i = 0; i < 8; ++i) {
        const Vec3d corner(i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                           i & 4 ? box.hi.z : box.lo.z);
        const Place at = project(camera, aspect, corner);
        farthest = std::fmax(farthest, std::fmax(std::fabs(at.x), std::fabs(at.y)));
      }
      EXPECT_LE(farthest, 0.5);
      EXPECT_GE(farthest, 0.45);
    }
  }
}

TEST(Framing, AnEmptySceneStillHasACamera) {
  const Camera camera = frame_scene(Bounds3f(), 1.5);
  EXPECT_TRUE(CameraRays::create(camera, picture(30, 20)));
  EXPECT_NEAR(length(camera.look_from - camera.look_at), 1, 1e-12);
}

TEST(Framing, APointIsLookedAtFromADistance) {
  const Camera camera = frame_scene({{2, 3, 4}, {2, 3, 4}}, 1);
  EXPECT_EQ(camera.look_at, Vec3d(2, 3, 4));
  EXPECT_NEAR(length(camera.look_from - camera.look_at), 1, 1e-12);
}

TEST(Framing, OrbitAnglesTurnAsDocumented) {
  const Vec3d target(1, 2, 3);
  const auto from = [&](double theta, double phi) {
    return orbit_camera({theta, phi, 2}, target, 45).look_from - target;
  };
  const auto expect_near = [](const Vec3d& a, const Vec3d& b) { EXPECT_LT(length(a - b), 1e-5); };
  expect_near(from(0, 90), {0, 0, 2});
  expect_near(from(90, 90), {2, 0, 0});
  expect_near(from(180, 90), {0, 0, -2});
  expect_near(from(37, 0), {0, 2, 0});
  expect_near(from(37, 180), {0, -2, 0});
}

TEST(Framing, StraightDownStillKnowsItsTop) {
  EXPECT_TRUE(CameraRays::create(orbit_camera({0, 0, 5}, {}, 45), picture(8, 8)));
  EXPECT_TRUE(CameraRays::create(orbit_camera({90, 180, 5}, {}, 45), picture(8, 8)));
}

TEST(OrthographicCamera, RaysAreParallelAndSpanTheHeight) {
  Camera camera;
  camera.look_from = {0, 0, 10};
  camera.look_at = {0, 0, 0};
  camera.aperture = 0;
  camera.orthographic_height = 4;
  const auto rays = CameraRays::create(camera, picture(40, 20));
  ASSERT_TRUE(rays);
  const Ray top_left = rays->generate(0, 0, {0, 0, 0, 0});
  const Ray bottom_right = rays->generate(39, 19, {1, 1, 0, 0});
  EXPECT_EQ(top_left.direction, bottom_right.direction);
  EXPECT_EQ(top_left.direction, Vec3f(0, 0, -10));
  EXPECT_LT(length(top_left.origin - Vec3f(-4, 2, 10)), 1e-5f);
  EXPECT_LT(length(bottom_right.origin - Vec3f(4, -2, 10)), 1e-5f);
}

}  // namespace
}  // namespace dapple
