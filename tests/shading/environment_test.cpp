#include "shading/environment_light.h"

#include <gtest/gtest.h>

#include <cstring>

#include "math/fast_functions.h"
#include "math/random.h"
#include "math/warps.h"
#include "shading/colour.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

constexpr int kWidth = 24, kHeight = 12;

// An image of noise with one bright texel.
Scene noisy_scene(float rotation) {
  Scene scene;
  scene.environment = {EnvironmentKind::image, ImageId{0}, {1, 1, 1}, rotation};
  scene.images.push_back({kWidth, kHeight, TexelFormat::rgb32f, 0, 0});
  scene.texels.resize(scene.images[0].bytes());
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 1);
    const float value[3] = {u[0], u[1] * u[1], i == 100 ? 50.0f : u[2]};
    std::memcpy(scene.texels.data() + std::size_t{12} * i, value, sizeof(value));
  }
  return scene;
}

Vec3f direction(float turns, float z_cosine) {
  const float sine = std::sqrt(1 - z_cosine * z_cosine);
  const SinCos<float> around = sin_cos_turns(turns);
  return {sine * around.cos, z_cosine, sine * around.sin};
}

TEST(EnvironmentLight, DensityIntegratesToOne) {
  for (const auto& scene : {noisy_scene(0), noisy_scene(77)}) {
    const EnvironmentLight light(scene, TextureSet(scene));
    constexpr int kSteps = 600;
    double sum = 0;
    for (int j = 0; j < kSteps; ++j) {
      const SinCos<float> polar = sin_cos_turns((static_cast<float>(j) + 0.5f) / (2 * kSteps));
      for (int i = 0; i < kSteps; ++i) {
        const Vec3f w = direction((static_cast<float>(i) + 0.5f) / kSteps, polar.cos);
        sum += light.pdf(w) * polar.sin;
      }
    }
    EXPECT_NEAR(sum * 2 * double{kPi} * double{kPi} / (kSteps * kSteps), 1, 1e-3);
  }
}

TEST(EnvironmentLight, SamplesFollowTheDensity) {
  const Scene scene = noisy_scene(30);
  const EnvironmentLight light(scene, TextureSet(scene));
  constexpr std::size_t kColumns = 20, kRows = 10, kSub = 24;
  std::vector<double> expected(kColumns * kRows);
  for (std::size_t j = 0; j < kRows * kSub; ++j) {
    for (std::size_t i = 0; i < kColumns * kSub; ++i) {
      const Vec3f w = direction((static_cast<float>(i) + 0.5f) / (kColumns * kSub),
                                2 * (static_cast<float>(j) + 0.5f) / (kRows * kSub) - 1);
      expected[j / kSub * kColumns + i / kSub] += light.pdf(w);
    }
  }
  Histogram found(kColumns, kRows);
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 9);
    const EnvironmentSample s = light.sample({u[0], u[1]});
    const double turns = fast_atan2(s.direction.z, s.direction.x) / (2 * double{kPi});
    found.add(turns < 0 ? turns + 1 : turns, (s.direction.y + 1) / 2);
    EXPECT_NEAR(s.pdf, light.pdf(s.direction), 0.02f * s.pdf);
    EXPECT_NEAR(luminance(s.radiance), luminance(light.radiance(s.direction)), 0.01f);
  }
  const ChiSquared fit = chi_squared_test(found.counts(), expected);
  EXPECT_GT(fit.p_value, kSignificance) << fit;
}

TEST(EnvironmentLight, SamplesGiveTheMeanRadiance) {
  const Scene scene = noisy_scene(0);
  const EnvironmentLight light(scene, TextureSet(scene));
  constexpr std::uint32_t kGrid = 300;
  double by_light = 0, by_sphere = 0;
  for (std::uint32_t i = 0; i < kGrid; ++i) {
    for (std::uint32_t j = 0; j < kGrid; ++j) {
      const Vec2f u{(static_cast<float>(i) + 0.5f) / kGrid, (static_cast<float>(j) + 0.5f) / kGrid};
      const EnvironmentSample s = light.sample(u);
      by_light += luminance(s.radiance) / s.pdf / (4 * double{kPi});
      by_sphere += luminance(light.radiance(sample_uniform_sphere(u.x, u.y)));
    }
  }
  EXPECT_NEAR(by_light / by_sphere, 1, 0.01);
  EXPECT_NEAR(by_sphere / (kGrid * kGrid) / luminance(light.mean_radiance()), 1, 0.02);
}

// The centre column lies at +x, columns go on towards +z, and rotation is counter-clockwise seen
// from above.
TEST(EnvironmentLight, StandsAsDescribed) {
  Scene scene = noisy_scene(0);
  const auto bright = [&](int column) {
    std::memset(scene.texels.data(), 0, scene.texels.size());
    const float white[3] = {1, 1, 1};
    for (int y = 0; y < kHeight; ++y) {
      std::memcpy(
          scene.texels.data() + std::size_t{12} * static_cast<std::size_t>(y * kWidth + column),
          white, sizeof(white));
    }
    return EnvironmentLight(scene, TextureSet(scene)).mean_radiance().x;
  };
  const auto seen = [&](const Vec3f& w) {
    return EnvironmentLight(scene, TextureSet(scene)).radiance(w).x;
  };
  EXPECT_GT(bright(kWidth / 2), 0);
  EXPECT_GT(seen({1, 0, 0}), 0.4);
  bright(kWidth * 3 / 4);
  EXPECT_GT(seen({0, 0, 1}), 0.4);
  EXPECT_EQ(seen({0, 0, -1}), 0);
  scene.environment.rotation = 90;  // takes +z to +x
  EXPECT_GT(seen({1, 0, 0}), 0.4);
  EXPECT_EQ(seen({0, 0, 1}), 0);
}

TEST(EnvironmentLight, TheStudioIsNeutralAndLightsTheFront) {
  Scene scene;
  scene.environment.kind = EnvironmentKind::studio;
  const EnvironmentLight light(scene, TextureSet(scene));
  const Vec3f mean = light.mean_radiance();
  EXPECT_NEAR(mean.x, mean.y, 1e-5);
  EXPECT_NEAR(mean.x, mean.z, 1e-5);
  EXPECT_GT(mean.x, 0.25);
  EXPECT_LT(mean.x, 1);
  EXPECT_GT(light.radiance(normalize(Vec3f(-1, 0.75f, 0.9f))).x, 3 * mean.x);
}

TEST(EnvironmentLight, NoneIsBlackAndConstantIsEven) {
  Scene scene;
  scene.environment.kind = EnvironmentKind::none;
  EXPECT_TRUE(EnvironmentLight(scene, TextureSet(scene)).is_black());
  scene.environment.kind = EnvironmentKind::constant;
  scene.environment.colour = {1, 2, 3};
  const EnvironmentLight even(scene, TextureSet(scene));
  EXPECT_EQ(even.radiance({0, 1, 0}), Vec3f(1, 2, 3));
  EXPECT_NEAR(even.pdf({0, 1, 0}), 1 / (4 * kPi), 1e-7);
}

}  // namespace
}  // namespace dapple::test
