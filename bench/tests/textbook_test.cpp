#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "math/warps.h"
#include "render/render_job.h"
#include "scene/named_scenes.h"
#include "textbook/renderer.h"

namespace dapple::textbook {
namespace {

dapple::Ray random_ray(std::uint32_t i, float size) {
  const auto u = uniform4(i, 0, 0, 0, 7);
  const auto v = uniform4(i, 0, 0, 1, 7);
  dapple::Ray ray;
  ray.origin = Vec3f(size * (2 * u[0] - 1), size * (2 * u[1] - 1), size * (2 * u[2] - 1));
  ray.direction = sample_uniform_sphere(v[0], v[1]);
  ray.t_min = 1e-3f;
  return ray;
}

class SameHits : public testing::TestWithParam<const char*> {};

// Distances agree to single precision; the few rays that graze an edge may differ.
TEST_P(SameHits, AsBruteForce) {
  constexpr std::uint32_t kRays = 20000;
  const Scene scene = *make_named_scene(GetParam());
  const auto accel = make_accel(AccelKind::linear, scene);
  World world(scene);
  world.build_tree();
  std::uint32_t hits = 0, differ = 0;
  for (std::uint32_t i = 0; i < kRays; ++i) {
    const dapple::Ray ray = random_ray(i, 30);
    const Hit expected = accel->intersect(ray);
    HitRecord record;
    const bool found =
        world.hit({Vec3d(ray.origin), Vec3d(ray.direction)}, double{ray.t_min}, HUGE_VAL, record);
    hits += found;
    const double expected_t = double{expected.t};
    differ += found != expected.found() ||
              (found && std::fabs(record.t - expected_t) > 1e-4 * (1 + expected_t));
  }
  EXPECT_GT(hits, kRays / 100);
  EXPECT_LT(differ, kRays / 1000);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameHits,
                         testing::Values("nice", "irreg:50", "rgbbox", "spheres:500"));

// Mean and mean square of a channel over a block of pixels.
struct Moments {
  double sum = 0, squares = 0, count = 0;
  void add(double x) {
    sum += x;
    squares += x * x;
    count += 1;
  }
  double mean() const { return sum / count; }
  double variance_of_mean() const { return (squares / count - mean() * mean()) / count; }
};

Moments moments_of(const Image& image, int block_x, int block_y, int side, int channel) {
  Moments m;
  for (int y = block_y; y < block_y + side; ++y) {
    for (int x = block_x; x < block_x + side; ++x) m.add(double{image.at(x, y)[channel]});
  }
  return m;
}

class SamePicture : public testing::TestWithParam<const char*> {};

// Block by block the means differ by no more than noise. The variance between the pixels of a
// block is at least that of the noise, so five deviations are not exceeded by chance.
TEST_P(SamePicture, AsDapple) {
  constexpr int kSide = 96, kBlock = 24;
  const Scene scene = *make_named_scene(GetParam());
  RenderSettings settings;
  settings.width = settings.height = kSide;
  settings.samples_per_pixel = 16;
  const auto ours = dapple::render({scene, make_accel(AccelKind::linear, scene)}, settings);
  ASSERT_TRUE(ours.has_value());
  World world(scene);
  world.build_tree();
  const Picture picture = render(world, scene.camera, settings);
  EXPECT_GE(picture.ray_count, std::uint64_t{kSide} * kSide * 16);
  for (int y = 0; y < kSide; y += kBlock) {
    for (int x = 0; x < kSide; x += kBlock) {
      for (int channel = 0; channel < 3; ++channel) {
        const Moments a = moments_of(ours->image, x, y, kBlock, channel);
        const Moments b = moments_of(picture.image, x, y, kBlock, channel);
        const double deviation = std::sqrt(a.variance_of_mean() + b.variance_of_mean());
        EXPECT_LE(std::fabs(a.mean() - b.mean()), 5 * deviation + 1e-5)
            << "block " << x << ", " << y << ", channel " << channel;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SamePicture, testing::Values("nice", "irreg:40", "spheres:300"));

}  // namespace
}  // namespace dapple::textbook
