// The rays of `dapple bench`.
#include "dapple/bench_rays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/named_scenes.h"

namespace dapple {
namespace {

TEST(BenchRays, OneCameraRayForEachPixel) {
  RenderSettings settings;
  settings.width = 70;
  settings.height = 33;
  const auto rays = make_camera_rays(Camera{}, settings);
  ASSERT_TRUE(rays);
  EXPECT_EQ(rays->size(), 70u * 33u);
}

TEST(BenchRays, BounceRaysLeaveTheSurfaceThatWasHit) {
  const Scene scene = *make_named_scene("rgbbox");
  const auto accel = make_accel(AccelKind::fast, scene);
  RenderSettings settings;
  settings.width = settings.height = 64;
  const auto rays = make_camera_rays(scene.camera, settings);
  ASSERT_TRUE(rays);
  const std::vector<Ray> bounced = make_bounce_rays(*accel, *rays, 0);
  std::size_t next = 0;
  for (const Ray& ray : *rays) {
    const Hit hit = accel->intersect(ray);
    if (!hit.found()) continue;
    ASSERT_LT(next, bounced.size());
    const Ray& bounce = bounced[next++];
    const SurfacePoint at = accel->locate(ray, hit);
    // Moved off the surface by its error, and rounded.
    const float rounding = 0x1p-23f * max_abs_component(at.position);
    EXPECT_LE(length(bounce.origin - at.position), at.error + rounding);
    EXPECT_NEAR(length(bounce.direction), 1.0f, 1e-5f);
    // Back to the side that the ray came from.
    EXPECT_LE(dot(bounce.direction, at.outward) * dot(ray.direction, at.outward), 1e-6f);
  }
  EXPECT_EQ(next, bounced.size());
  EXPECT_GT(next, 0u);
}

TEST(BenchRays, NothingHitLeavesNoRays) {
  const Scene scene = *make_named_scene("empty");
  const auto accel = make_accel(AccelKind::fast, scene);
  RenderSettings settings;
  const auto rays = make_camera_rays(scene.camera, settings);
  ASSERT_TRUE(rays);
  EXPECT_TRUE(make_bounce_rays(*accel, *rays, 0).empty());
}

}  // namespace
}  // namespace dapple
