// Trees of every quality find the same hits, and better ones cost less; refitted trees find those
// of the moved scene.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "accel/accel.h"
#include "accel/wide_builder.h"
#include "accel/wide_stats.h"
#include "scene/named_scenes.h"
#include "tests/scenes/meshes.h"
#include "tests/scenes/nasty_scenes.h"

namespace dapple::test {
namespace {

constexpr BvhQuality kQualities[] = {BvhQuality::low, BvhQuality::medium, BvhQuality::high};
constexpr LeafForm kForms[] = {LeafForm::whole, LeafForm::compact};

Scene bumpy_mesh() {
  Scene scene;
  add_cube_mesh({{0, 0, 0}, 1, 40, 1, 0.3f}, scene.add_material(Lambertian{}), scene);
  return scene;
}

TEST(Qualities, AllFindTheSameHits) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const NastyConfig config = nasty_config(seed);
    const Scene scene = nasty_scene(config, seed);
    const auto rays = nasty_rays(scene, config, 500, seed);
    const auto linear = make_accel(AccelKind::linear, scene);
    std::vector<Hit> expected(rays.size()), hits(rays.size());
    linear->intersect(rays, expected);
    for (const BvhQuality quality : kQualities) {
      make_accel(AccelKind::fast, scene, quality)->intersect(rays, hits);
      ASSERT_EQ(hits, expected) << "seed " << seed << ", " << bvh_quality_name(quality);
    }
  }
}

TEST(Qualities, BetterTreesCostLess) {
  for (const Scene& scene : {bumpy_mesh(), *make_named_scene("spheres:20000")}) {
    double before = std::numeric_limits<double>::infinity();
    for (const BvhQuality quality : kQualities) {
      const double cost = make_accel(AccelKind::fast, scene, quality)->stats().sah_cost;
      EXPECT_LT(cost, before) << bvh_quality_name(quality);
      before = cost;
    }
  }
}

TEST(Qualities, HaveNames) {
  for (const BvhQuality quality : kQualities) {
    EXPECT_EQ(parse_bvh_quality(bvh_quality_name(quality)).value(), quality);
  }
  ASSERT_FALSE(parse_bvh_quality("best"));
  EXPECT_EQ(parse_bvh_quality("best").error().code, Errc::usage);
}

TEST(Refit, OfAnUnmovedSceneChangesNothing) {
  NastyConfig config;
  config.shapes = Shapes::everything;
  config.object_count = 3000;
  const Scene scene = nasty_scene(config, 8);
  for (const LeafForm form : kForms) {
    const WideBvh built = build_wide_bvh(scene, nullptr, BvhQuality::medium, form);
    WideBvh fitted = build_wide_bvh(scene, nullptr, BvhQuality::medium, form);
    refit_wide_bvh(scene, fitted);
    const auto expected = built.view(), actual = fitted.view();
    EXPECT_EQ(std::memcmp(actual.nodes.data(), expected.nodes.data(), expected.nodes.size_bytes()),
              0);
    EXPECT_EQ(std::memcmp(actual.rows.data(), expected.rows.data(), expected.rows.size_bytes()), 0);
  }
}

TEST(Refit, FindsTheHitsOfTheMovedScene) {
  NastyConfig config;
  config.shapes = Shapes::everything;
  config.object_count = 500;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    Scene scene = nasty_scene(config, seed);
    WideBvh bvh = build_wide_bvh(scene, nullptr, BvhQuality::medium, kForms[seed % 2]);
    for (std::size_t i = 0; i < scene.vertices.positions.size(); ++i) {
      Vec3f& p = scene.vertices.positions[i];
      p = Vec3f(p.y, -p.x, p.z + 0.1f * static_cast<float>(i % 7));
    }
    for (Sphere& sphere : scene.spheres) sphere.centre.x += 0.5;
    for (Instance& instance : scene.instances) instance.to_world.rows[1][3] -= 0.25f;
    refit_wide_bvh(scene, bvh);
    SceneView view(scene);
    view.bvh = bvh.view();
    const auto rays = nasty_rays(scene, config, 3000, seed);
    std::vector<Hit> expected(rays.size()), hits(rays.size());
    make_accel(AccelKind::linear, scene)->intersect(rays, expected);
    make_accel(AccelKind::fast, view)->intersect(rays, hits);
    ASSERT_EQ(hits, expected) << "seed " << seed;
  }
}

}  // namespace
}  // namespace dapple::test
