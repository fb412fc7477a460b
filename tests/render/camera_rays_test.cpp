// Camera rays against a pinhole and lens written down independently, by angles.
#include "render/camera_rays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "tests/scenes/picture_scenes.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::array<float, 4> kLensCentre = {0.5f, 0.5f, 0, 0};

RenderSettings size(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  return settings;
}

Camera axis_camera() {  // at the origin, along -z, y up
  Camera camera;
  camera.look_from = {0, 0, 0};
  camera.look_at = {0, 0, -4};
  return camera;
}

// Tangents of the angles of a direction to the right of and above the axis of axis_camera().
struct Tangent {
  double right, up;
};
Tangent tangent_of(const Ray& ray) {
  return {double{ray.direction.x} / -ray.direction.z, double{ray.direction.y} / -ray.direction.z};
}

TEST(CameraRays, TheFirstRowIsTheTopAndColumnsGoRight) {
  Camera camera = axis_camera();
  camera.aperture = 0;
  const CameraRays rays = CameraRays::create(camera, size(8, 6)).value();
  const Tangent top_left = tangent_of(rays.generate(0, 0, kLensCentre));
  const Tangent bottom_right = tangent_of(rays.generate(7, 5, kLensCentre));
  EXPECT_LT(top_left.right, 0);
  EXPECT_GT(top_left.up, 0);
  EXPECT_GT(bottom_right.right, 0);
  EXPECT_LT(bottom_right.up, 0);
}

// The picture's upper and lower edges are the field of view apart; pixels are square and cover
// the picture plane evenly.
TEST(CameraRays, PixelsCoverTheFieldOfView) {
  Camera camera = axis_camera();
  camera.aperture = 0;
  for (const double fov : {1.0, 40.0, 75.0, 120.0, 175.0}) {
    camera.vertical_fov = fov;
    for (const auto& [width, height] : {std::pair(1, 1), {37, 11}, {16, 64}}) {
      const CameraRays rays = CameraRays::create(camera, size(width, height)).value();
      const double edge = std::tan(fov / 360 * kPi);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const auto u =
              uniform4(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0, 1);
          const Tangent t = tangent_of(rays.generate(x, y, u));
          const double column = x + double{u[0]}, row = y + double{u[1]};
          const double tolerance = 1e-6 * edge * (1 + double(width) / height);
          ASSERT_NEAR(t.up, edge * (1 - 2 * row / height), tolerance);
          ASSERT_NEAR(t.right, edge * (2 * column - width) / height, tolerance);
        }
      }
    }
  }
}

// Any camera: the ray through the middle of the picture passes look_at, `up` is upwards in it.
TEST(CameraRays, TheMiddleLooksAtTheTarget) {
  for (const PictureScene& scene : picture_scenes()) {
    Camera camera = scene.scene.camera;
    camera.aperture = 0;
    const CameraRays rays = CameraRays::create(camera, size(2, 2)).value();
    const Vec3d forward = normalize(camera.look_at - camera.look_from);
    const Ray middle = rays.generate(1, 1, {0, 0, 0, 0});
    EXPECT_LT(length(cross(normalize(Vec3d(middle.direction)), forward)), 1e-6) << scene.name;
    EXPECT_GT(dot(Vec3d(middle.direction), forward), 0);
    const Vec3d above =
        Vec3d(rays.generate(1, 0, {0, 0, 0, 0}).direction) - Vec3d(middle.direction);
    EXPECT_GT(dot(above, camera.up), 0);
    EXPECT_NEAR(dot(above, forward), 0, 1e-5 * length(above));
    EXPECT_NEAR(dot(above, cross(forward, camera.up)), 0, 1e-5 * length(above));
  }
}

// Rays of one picture point from everywhere on the lens meet in one point of the focus plane, at
// t = 1, and start uniformly on the disc.
TEST(CameraRays, TheLensIsAUniformDiscThatFocuses) {
  Camera camera = axis_camera();
  camera.aperture = 3;
  camera.focus_distance = 7;
  const CameraRays rays = CameraRays::create(camera, size(10, 10)).value();
  Camera pinhole = camera;
  pinhole.aperture = 0;
  const CameraRays straight = CameraRays::create(pinhole, size(10, 10)).value();
  Histogram disc(24, 24);
  for (std::uint32_t i = 0; i < 200'000; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 2);
    const Ray ray = rays.generate(2, 8, u);
    const Vec3f focus = straight.generate(2, 8, u).at(1);
    ASSERT_LT(length(ray.at(1) - focus), 1e-5);
    ASSERT_NEAR(focus.z, -7, 1e-5);
    ASSERT_EQ(ray.origin.z, 0.0f);
    const double radius = length(Vec3d(ray.origin)) / 1.5;
    ASSERT_LE(radius, 1 + 1e-6);
    disc.add(std::atan2(ray.origin.y, ray.origin.x) / (2 * kPi) + 0.5, radius * radius);
  }
  const ChiSquared result = chi_squared_test_uniform(disc.counts());
  EXPECT_GT(result.p_value, kSignificance) << result;
}

TEST(CameraRays, HitsCountFromAThousandth) {
  const CameraRays rays = CameraRays::create(axis_camera(), size(2, 2)).value();
  EXPECT_EQ(rays.generate(0, 0, kLensCentre).t_min, 1e-3f);
  EXPECT_EQ(rays.generate(0, 0, kLensCentre).t_max, HUGE_VALF);
}

TEST(CameraRays, DegenerateCamerasAreErrors) {
  Camera blind = axis_camera();
  blind.look_at = blind.look_from;
  EXPECT_FALSE(CameraRays::create(blind, size(2, 2)));
  Camera upright = axis_camera();
  upright.up = {0, 0, -2};
  EXPECT_FALSE(CameraRays::create(upright, size(2, 2)));
  Camera no_up = axis_camera();
  no_up.up = {0, 0, 0};
  EXPECT_FALSE(CameraRays::create(no_up, size(2, 2)));
}

// Without a lens, where the camera is focused changes nothing but the unit of distances.
TEST(CameraRays, PinholesLookTheSameWayAtAnyFocus) {
  for (const double height : {0.0, 3.0}) {
    Camera camera = axis_camera();
    camera.aperture = 0;
    camera.orthographic_height = height;
    camera.focus_distance = 1;
    const CameraRays expected = CameraRays::create(camera, size(8, 6)).value();
    for (const double focus : {5e-324, 1e-30, 1e-22, 1e-9, 1e9, 1e18, 1e300}) {
      camera.focus_distance = focus;
      const auto rays = CameraRays::create(camera, size(8, 6));
      ASSERT_TRUE(rays) << focus;
      for (int x = 0; x < 8; ++x) {
        const Ray ray = rays->generate(x, 2, kLensCentre);
        const Ray same = expected.generate(x, 2, kLensCentre);
        const Vec3f direction = normalize(ray.direction);
        ASSERT_TRUE(is_finite(direction)) << focus;
        EXPECT_LT(length(direction - normalize(same.direction)), 1e-6f) << focus;
        if (focus > 1) continue;
        EXPECT_LT(length(ray.origin - same.origin), 1e-5f) << focus;
      }
    }
  }
}

TEST(CameraRays, ALensIsFocusedWithinBounds) {
  Camera camera = axis_camera();
  camera.aperture = 1e-3;
  for (const double focus : {1e-30, 1e18}) {
    camera.focus_distance = focus;
    const auto rays = CameraRays::create(camera, size(8, 6));
    ASSERT_FALSE(rays) << focus;
    EXPECT_EQ(rays.error().code, Errc::bad_data);
  }
}

}  // namespace
}  // namespace dapple::test
