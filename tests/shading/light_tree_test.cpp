#include "shading/light_tree.h"

#include <gtest/gtest.h>

#include <vector>

#include "math/random.h"
#include "math/warps.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

// Small lights of various powers in a cube, some that shine all around and some along an axis.
std::vector<LightBounds> random_lights(std::uint32_t count) {
  std::vector<LightBounds> lights(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 3), v = uniform4(i, 1, 0, 0, 3);
    const Vec3f p(u[0], u[1], u[2]);
    const Vec3f half = 0.02f * Vec3f(v[0], v[1], v[2]);
    lights[i].bounds = {p - half, p + half};
    lights[i].axis = sample_uniform_sphere(v[0], v[1]);
    lights[i].cos_spread = v[2] < 0.3f ? 0.0f : 0.9f;
    lights[i].power = u[3] * u[3] + 0.01f;
  }
  return lights;
}

const Vec3f kPoints[] = {{0.5f, 0.5f, 0.5f}, {3, 0, 0}, {0.1f, 0.9f, 1.3f}, {-40, 20, 7}};
const Vec3f kNormals[] = {{0, 0, 0}, {0, 0, 1}, {0.6f, 0.8f, 0}};

TEST(LightTree, ProbabilitiesSumToOne) {
  for (const std::uint32_t count : {1u, 2u, 3u, 17u, 500u}) {
    const LightTree tree(random_lights(count));
    for (const Vec3f& p : kPoints) {
      double sum = 0;
      for (std::uint32_t i = 0; i < count; ++i) sum += tree.probability(p, {}, i);
      EXPECT_NEAR(sum, 1, 1e-4) << count;
    }
  }
}

TEST(LightTree, ChoosesAsItsProbabilitiesSay) {
  constexpr std::uint32_t kLights = 60;
  constexpr int kChoices = 100'000;
  const LightTree tree(random_lights(kLights));
  for (const Vec3f& p : kPoints) {
    for (const Vec3f& n : kNormals) {
      std::vector<double> counts(kLights + 1), expected(kLights + 1);
      double sum = 0;
      for (std::uint32_t i = 0; i < kLights; ++i) {
        expected[i] = kChoices * static_cast<double>(tree.probability(p, n, i));
        sum += expected[i];
      }
      expected[kLights] = std::max(kChoices - sum, 0.0);  // no choice
      if (expected[kLights] < 1) expected[kLights] = 0;
      for (int i = 0; i < kChoices; ++i) {
        const float u = uniform4(static_cast<std::uint32_t>(i), 0, 0, 0, 8)[0];
        const auto choice = tree.choose(p, n, u);
        ++counts[choice ? choice->light : kLights];
        if (choice) {
          EXPECT_NEAR(choice->probability, tree.probability(p, n, choice->light),
                      1e-4f * choice->probability);
        }
      }
      const ChiSquared fit = chi_squared_test(counts, expected);
      EXPECT_GT(fit.p_value, corrected_significance(12)) << fit;
    }
  }
}

// A light that reaches a point has a chance there.
TEST(LightTree, LeavesNoContributionOut) {
  const auto lights = random_lights(300);
  const LightTree tree(lights);
  for (std::uint32_t k = 0; k < 200; ++k) {
    const auto u = uniform4(k, 0, 0, 0, 4);
    const Vec3f p = 3.0f * Vec3f(u[0], u[1], u[2]) - Vec3f(1, 1, 1);
    const Vec3f n = sample_uniform_sphere(u[3], u[0]);
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      if (importance(lights[i], p, n) > 0) {
        EXPECT_GT(tree.probability(p, n, i), 0);
      }
    }
  }
}

TEST(LightTree, PrefersWhatIsNearAndStrong) {
  std::vector<LightBounds> lights(2);
  for (auto& light : lights) light.cos_spread = 0, light.power = 1;
  lights[0].bounds = {{1, 0, 0}, {1, 0, 0}};
  lights[1].bounds = {{2, 0, 0}, {2, 0, 0}};
  EXPECT_NEAR(LightTree(lights).probability({0, 0, 0}, {}, 0), 0.8, 1e-6);
  lights[1].power = 4;
  EXPECT_NEAR(LightTree(lights).probability({0, 0, 0}, {}, 0), 0.5, 1e-6);
}

TEST(LightTree, LightsWithoutPowerAreNotChosen) {
  std::vector<LightBounds> lights = random_lights(3);
  lights[1].power = 0;
  EXPECT_EQ(LightTree(lights).probability({0, 0, 0}, {}, 1), 0);
  lights[0].power = lights[2].power = 0;
  EXPECT_TRUE(LightTree(lights).empty());
}

}  // namespace
}  // namespace dapple::test
