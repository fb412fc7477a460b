// The proof of a BVH over shapes of every kind, with the trees of prototypes behind that of the
// world.
#include <gtest/gtest.h>

#include <algorithm>

#include "accel/wide_builder.h"
#include "math/random.h"
#include "scene/validate.h"
#include "scene_file/verify_bvh.h"
#include "tests/scene_file/small_bvh.h"
#include "tests/scenes/nasty_scenes.h"
#include "tests/scenes/slivers.h"

namespace dapple::test {
namespace {

Scene scene_of(Shapes shapes, std::uint64_t seed) {
  NastyConfig config;
  config.shapes = shapes;
  config.object_count = 40;
  config.odd_share = seed % 2 == 0 ? 0.1 : 0.5;
  return nasty_scene(config, seed);
}

BvhDamage damage_of(const WideBvhView& bvh, const Scene& scene) {
  const SceneView view(scene);
  return BvhVerifier(bvh, view).check_everything();
}

TEST(VerifyShapes, AcceptsWhatBuildersMake) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    for (const Shapes shapes : {Shapes::triangles, Shapes::everything, Shapes::instances}) {
      const Scene scene = scene_of(shapes, seed);
      const auto small = build_small_bvh(scene, 2 + seed % 15, 1 + seed % 16);
      const BvhDamage of_small = damage_of(small.view(), scene);
      EXPECT_TRUE(of_small.ok()) << "seed " << seed << ": " << of_small.reason;
      const WideBvh wide = build_wide_bvh(scene);
      const BvhDamage of_wide = damage_of(wide.view(), scene);
      EXPECT_TRUE(of_wide.ok()) << "seed " << seed << ": " << of_wide.reason;
    }
  }
}

// A file's tree holds each triangle once and whole.
TEST(VerifyShapes, AcceptsEveryQualityButNoPartsOfTriangles) {
  const Scene scene = sliver_scene(Slivers::beams, 6000, 1);
  for (const BvhQuality quality : {BvhQuality::low, BvhQuality::medium, BvhQuality::high}) {
    const WideBvh whole = build_wide_bvh(scene, nullptr, quality);
    const BvhDamage damage = damage_of(whole.view(), scene);
    EXPECT_TRUE(damage.ok()) << damage.reason;
  }
  const WideBvh parts = build_wide_bvh(scene, nullptr, BvhQuality::high, LeafForm::whole,
                                       TriangleParts::where_they_pay);
  EXPECT_FALSE(damage_of(parts.view(), scene).ok());
}

TEST(VerifyShapes, RefusesEveryChangeOfALeaf) {
  const Scene scene = scene_of(Shapes::everything, 4);
  SmallBvh bvh = build_small_bvh(scene);
  for (std::uint32_t row = 0; row < bvh.rows.size(); ++row) {
    const auto pick = philox4x32({row, 0, 0, 2}, 5);
    std::uint32_t& word = bvh.rows[row].words[pick[0] % kLeafWidth];
    const std::uint32_t before = word;
    for (const std::uint32_t mask : {1u, 0x80000000u, 1u << pick[1] % 32}) {
      word = before ^ mask;
      EXPECT_FALSE(damage_of(bvh.view(), scene).ok()) << "row " << row << " mask " << mask;
      word = before;
    }
  }
}

TEST(VerifyShapes, RefusesTreesThatAreMissingOrOneTooMany) {
  const Scene scene = scene_of(Shapes::instances, 6);
  const SmallBvh bvh = build_small_bvh(scene);
  const std::vector<std::uint32_t> roots = tree_roots(bvh.nodes);
  ASSERT_EQ(roots.size(), 5u);  // the world and four prototypes
  SmallBvh shorter = bvh;
  shorter.nodes.resize(roots.back());
  EXPECT_FALSE(damage_of(shorter.view(), scene).ok());
  SmallBvh longer = bvh;
  longer.nodes.push_back(bvh.nodes[roots.back()]);
  EXPECT_FALSE(damage_of(longer.view(), scene).ok());
}

// The trees of two prototypes with as many triangles, exchanged.
TEST(VerifyShapes, RefusesTheTreeOfAnotherPrototype) {
  Scene scene;
  const MaterialId material = scene.add_material(Lambertian{});
  scene.vertices.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Triangle one[] = {{{0, 1, 2}}}, other[] = {{{1, 2, 0}}};
  const MaterialId materials[] = {material};
  for (const auto& triangles : {one, other}) {
    Instance instance;
    instance.prototype = scene.add_prototype({triangles, 1}, materials);
    scene.add_instance(instance);
  }
  SmallBvh bvh = build_small_bvh(scene);
  ASSERT_TRUE(damage_of(bvh.view(), scene).ok());
  const std::size_t rows = leaf_rows(ShapeKind::triangle);
  std::swap_ranges(bvh.rows.end() - static_cast<std::ptrdiff_t>(rows), bvh.rows.end(),
                   bvh.rows.end() - static_cast<std::ptrdiff_t>(2 * rows));
  const BvhDamage damage = damage_of(bvh.view(), scene);
  ASSERT_FALSE(damage.ok());
  EXPECT_STREQ(damage.reason, "a primitive's id is not one of its kind");
}

}  // namespace
}  // namespace dapple::test
