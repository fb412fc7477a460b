// Brute force = median = fast, bit for bit, on every instruction set, over scenes and rays made to
// find differences.
#include <gtest/gtest.h>

#include <memory>

#include "accel/accel.h"
#include "accel/kernels/dispatch.h"
#include "math/random.h"
#include "scene/named_scenes.h"
#include "scene/validate.h"
#include "tests/accel/scalar_oracle.h"
#include "tests/scenes/nasty_scenes.h"

namespace dapple::test {
namespace {

struct Structure {
  AccelKind kind;
  LeafForm form = LeafForm::whole;

  std::unique_ptr<Accel> over(const SceneView& scene) const {
    return make_accel(kind, scene, BvhQuality::medium, form);
  }
  std::string name() const {
    return std::string(accel_name(kind)) + (form == LeafForm::compact ? ", compact" : "");
  }
};
constexpr Structure kStructures[] = {{AccelKind::linear},
                                     {AccelKind::median},
                                     {AccelKind::fast},
                                     {AccelKind::fast, LeafForm::compact}};

constexpr std::size_t kShards = 8;
constexpr std::size_t kScenesPerShard = 100;
constexpr std::size_t kRaysPerScene = 13'000;
static_assert(kShards * kScenesPerShard * kRaysPerScene >= 10'000'000);

struct Answers {
  std::vector<Hit> hits;
  std::vector<std::uint8_t> occluded;
};

Answers oracle_answers(const Scene& scene, const std::vector<Ray>& rays) {
  const ScalarOracle oracle(scene);
  Answers answers;
  for (const Ray& ray : rays) {
    answers.hits.push_back(oracle.intersect(ray));
    answers.occluded.push_back(answers.hits.back().found());
  }
  return answers;
}

Answers answers_of(const Accel& accel, const std::vector<Ray>& rays) {
  Answers answers{std::vector<Hit>(rays.size()), std::vector<std::uint8_t>(rays.size(), 2)};
  accel.intersect(rays, answers.hits);
  accel.occluded(rays, answers.occluded);
  return answers;
}

std::string describe(const Ray& r) {
  char text[256];
  std::snprintf(text, sizeof(text), "ray from (%a, %a, %a) along (%a, %a, %a), t in [%a, %a]",
                r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z,
                r.t_min, r.t_max);
  return text;
}

// Reports the first difference only: one is enough, and there may be thousands.
void expect_same(const Answers& expected, const Answers& actual, const std::vector<Ray>& rays,
                 const std::string& what) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (expected.hits[i] == actual.hits[i] && expected.occluded[i] == actual.occluded[i]) continue;
    ADD_FAILURE() << what << ", " << describe(rays[i]) << ": expected t " << expected.hits[i].t
                  << " prim " << expected.hits[i].prim << ", got t " << actual.hits[i].t << " prim "
                  << actual.hits[i].prim << ", occluded " << int{actual.occluded[i]};
    return;
  }
}

// Every structure on every instruction set against the definition.
void expect_all_agree(const Scene& scene, const std::vector<Ray>& rays, const std::string& what) {
  const Answers expected = oracle_answers(scene, rays);
  for (const Structure& structure : kStructures) {
    const auto accel = structure.over(scene);
    for (const std::string_view isa : available_isas()) {
      if (structure.kind == AccelKind::median && isa != available_isas().front())
        continue;  // scalar
      ASSERT_TRUE(force_isa(isa));
      ASSERT_EQ(kernels().isa, isa);
      expect_same(expected, answers_of(*accel, rays), rays,
                  what + ", " + structure.name() + " on " + std::string(isa));
    }
  }
  ASSERT_TRUE(force_isa(available_isas().front()));
}

// Rays that go much the same way as the base ray, as those of a camera do: packets take these.
std::vector<Ray> bundle(const Ray& base, std::size_t count, std::uint32_t seed) {
  std::vector<Ray> rays(count, base);
  const float spread = (seed % 2 == 0 ? 1e-3f : 5e-2f) * max_abs_component(base.direction);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto u = uniform4(i, seed, 0, 0, 17);
    const Vec3f jitter(u[0] - 0.5f, u[1] - 0.5f, u[2] - 0.5f);
    rays[i].direction = base.direction + spread * jitter;
  }
  return rays;
}

class Agreement : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Agreement, OverNastyScenes) {
  std::size_t found = 0, rays_in_all = 0;
  for (std::size_t i = 0; i < kScenesPerShard; ++i) {
    const std::uint64_t seed = GetParam() * kScenesPerShard + i;
    const NastyConfig config = nasty_config(seed);
    const Scene scene = nasty_scene(config, seed);
    const auto valid = validate(SceneView(scene));
    ASSERT_TRUE(valid) << "seed " << seed << ": " << to_string(valid.error());
    const auto rays = nasty_rays(scene, config, kRaysPerScene, seed);
    expect_all_agree(scene, rays, "scene of seed " + std::to_string(seed));
    for (const std::uint8_t hit :
         oracle_answers(scene, {rays.begin(), rays.begin() + 100}).occluded) {
      found += hit;
      ++rays_in_all;
    }
    if (HasFailure()) return;
  }
  // The rays must be worth it: neither all misses nor all hits.
  EXPECT_GT(found, rays_in_all / 10);
  EXPECT_LT(found, rays_in_all * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Shards, Agreement, ::testing::Range(std::size_t{0}, kShards));

// Deep trees: many objects, few rays.
TEST(AgreementOfLargeScenes, OverManyObjects) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    NastyConfig config = nasty_config(9000 + seed);
    config.shapes = static_cast<Shapes>(seed % kShapesCount);
    config.object_count = 30'000;
    config.size = 100;
    config.distance = seed < 3 ? 0 : 1000;
    config.odd_share = 0.01;
    const Scene scene = nasty_scene(config, seed);
    const auto rays = nasty_rays(scene, config, 700, seed);
    expect_all_agree(scene, rays, "large scene " + std::to_string(seed));
  }
}

TEST(AgreementOfLargeScenes, OverNamedScenes) {
  for (const char* name : {"empty", "nice", "irreg", "rgbbox", "spheres:20000"}) {
    const Scene scene = make_named_scene(name).value();
    NastyConfig config;
    config.size = 100;
    expect_all_agree(scene, nasty_rays(scene, config, 4000, 1), name);
  }
}

// Everything coincident: the lowest id must win among hundreds of equal distances.
TEST(Ties, TheLowestIdWins) {
  Scene scene;
  const MaterialId material = scene.add_material(Lambertian{});
  for (int i = 0; i < 300; ++i) {
    scene.add_sphere({{0, 0, 0}, 1}, material);
    scene.add_rectangle(ShapeKind::xy_rectangle, {-2, 2, -2, 2, 5}, material);
    scene.add_rectangle(ShapeKind::xz_rectangle, {-2, 2, -2, 2, 5}, material);
  }
  NastyConfig config;
  const auto rays = nasty_rays(scene, config, 20'000, 3);
  expect_all_agree(scene, rays, "coincident objects");
  for (const Structure& structure : kStructures) {
    const auto accel = structure.over(scene);
    Ray ray;
    ray.origin = {0.1f, 0.2f, -9};
    ray.direction = {0, 0, 1};
    EXPECT_EQ(accel->intersect(ray).prim, 0u);
    ray.origin.x = 1.5f;
    EXPECT_EQ(accel->intersect(ray).prim, 300u);
  }
}

// One ray at a time, in streams of any length, in any order: the same answers.
TEST(Streams, LengthAndOrderMakeNoDifference) {
  const NastyConfig config;
  const Scene scene = nasty_scene(config, 5);
  auto rays = nasty_rays(scene, config, 1000, 5);
  for (const Structure& structure : kStructures) {
    const auto accel = structure.over(scene);
    const Answers whole = answers_of(*accel, rays);
    for (const std::size_t length : {1u, 3u, 16u, 333u}) {
      std::vector<Hit> hits(rays.size());
      for (std::size_t i = 0; i < rays.size(); i += length) {
        const std::size_t n = std::min(length, rays.size() - i);
        accel->intersect(std::span(rays).subspan(i, n), std::span(hits).subspan(i, n));
      }
      EXPECT_EQ(hits, whole.hits) << structure.name() << ", length " << length;
    }
    for (std::size_t i = rays.size(); i-- > 0;) {
      ASSERT_EQ(accel->intersect(rays[i]), whole.hits[i]);
      ASSERT_EQ(accel->occluded(rays[i]), whole.occluded[i] != 0);
    }
  }
}

TEST(Bundles, AgreeOverNastyScenes) {
  constexpr std::size_t kScenes = 60, kBundles = 24, kBundleSize = 96;
  for (std::uint64_t seed = 1000; seed < 1000 + kScenes; ++seed) {
    const NastyConfig config = nasty_config(seed);
    const Scene scene = nasty_scene(config, seed);
    std::vector<Ray> rays;
    for (const Ray& base : nasty_rays(scene, config, kBundles, seed)) {
      const auto of_base = bundle(base, kBundleSize, static_cast<std::uint32_t>(rays.size()));
      rays.insert(rays.end(), of_base.begin(), of_base.end());
    }
    expect_all_agree(scene, rays, "bundles, scene of seed " + std::to_string(seed));
  }
}

}  // namespace
}  // namespace dapple::test
