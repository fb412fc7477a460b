// The trees are the same for any number of threads.
#include <gtest/gtest.h>

#include <cstring>

#include "accel/accel.h"
#include "accel/wide_builder.h"
#include "parallel/parallel.h"
#include "scene/named_scenes.h"
#include "tests/scenes/nasty_scenes.h"
#include "tests/scenes/slivers.h"

namespace dapple::test {
namespace {

constexpr int kThreadCounts[] = {2, 3, 7};

// Puts the number of threads back when a test ends, however it ends.
class ThreadCount {
 public:
  explicit ThreadCount(int count) { set_thread_count(count); }
  ~ThreadCount() { set_thread_count(0); }
};

std::vector<Scene> scenes() {
  std::vector<Scene> result;
  for (const char* name : {"nice", "irreg:150", "spheres:50000"}) {
    result.push_back(make_named_scene(name).value());
  }
  NastyConfig config;
  config.object_count = 40'000;
  config.on_grid = true;  // thousands of equal coordinates and costs
  result.push_back(nasty_scene(config, 1));
  config.shapes = Shapes::rectangles;
  config.odd_share = 0.5;
  result.push_back(nasty_scene(config, 2));
  config.shapes = Shapes::everything;
  config.object_count = 4000;
  result.push_back(nasty_scene(config, 3));
  result.push_back(sliver_scene(Slivers::needles, 50'000, 1));  // split into parts
  return result;
}

constexpr BvhQuality kQualities[] = {BvhQuality::low, BvhQuality::medium, BvhQuality::high};

class TreesOfEachQuality : public ::testing::TestWithParam<BvhQuality> {};

TEST_P(TreesOfEachQuality, AreTheSameToTheLastByte) {
  for (const Scene& scene : scenes()) {
    WideBvh alone;
    {
      const ThreadCount one(1);
      alone = build_wide_bvh(scene, nullptr, GetParam(), LeafForm::whole,
                             TriangleParts::where_they_pay);
    }
    for (const int count : kThreadCounts) {
      const ThreadCount threads(count);
      const WideBvh built = build_wide_bvh(scene, nullptr, GetParam(), LeafForm::whole,
                                           TriangleParts::where_they_pay);
      const auto expected = alone.view(), actual = built.view();
      ASSERT_EQ(actual.nodes.size(), expected.nodes.size());
      ASSERT_EQ(actual.rows.size(), expected.rows.size());
      EXPECT_EQ(
          std::memcmp(actual.nodes.data(), expected.nodes.data(), expected.nodes.size_bytes()), 0);
      EXPECT_EQ(std::memcmp(actual.rows.data(), expected.rows.data(), expected.rows.size_bytes()),
                0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Qualities, TreesOfEachQuality, ::testing::ValuesIn(kQualities));

TEST(ThreadCounts, HitsAndStatisticsOfEveryStructureAreTheSame) {
  for (const Scene& scene : scenes()) {
    NastyConfig config;
    const auto rays = nasty_rays(scene, config, 300, 1);
    for (const AccelKind kind : {AccelKind::linear, AccelKind::median, AccelKind::fast}) {
      std::vector<Hit> expected(rays.size()), actual(rays.size());
      AccelStats stats;
      {
        const ThreadCount one(1);
        const auto accel = make_accel(kind, scene);
        accel->intersect(rays, expected);
        stats = accel->stats();
      }
      for (const int count : kThreadCounts) {
        const ThreadCount threads(count);
        const auto accel = make_accel(kind, scene);
        accel->intersect(rays, actual);
        EXPECT_EQ(actual, expected);
        EXPECT_EQ(accel->stats().node_count, stats.node_count);
        EXPECT_EQ(accel->stats().leaf_count, stats.leaf_count);
        EXPECT_EQ(accel->stats().depth, stats.depth);
        EXPECT_EQ(accel->stats().sah_cost, stats.sah_cost);
      }
    }
  }
}

// What every structure says about itself.
TEST(Structures, BoundsAndCountsAreThoseOfTheScene) {
  for (const Scene& scene : scenes()) {
    const auto linear = make_accel(AccelKind::linear, scene);
    for (const AccelKind kind : {AccelKind::median, AccelKind::fast}) {
      const auto accel = make_accel(kind, scene);
      EXPECT_EQ(accel->bounds(), linear->bounds()) << accel_name(kind);
      EXPECT_EQ(accel->stats().prim_count, SceneView(scene).object_count());
      EXPECT_GT(accel->stats().bytes, 0u);
    }
    EXPECT_EQ(linear->stats().prim_count, SceneView(scene).object_count());
  }
}

}  // namespace
}  // namespace dapple::test
