#include "kernels/ray_sets.h"

#include <gtest/gtest.h>

#include "kernels/agreement.h"
#include "kernels/peers.h"
#include "scene/named_scenes.h"

namespace dapple::bench {
namespace {

constexpr int kSide = 40;

struct World {
  Scene scene;
  Contenders contenders;
  std::vector<RaySet> sets;

  explicit World(const char* name) : scene(*make_named_scene(name)) {
    ContenderChoice linear;
    linear.accel = "linear";
    contenders = *make_contenders(linear);
    for (const auto& contender : contenders) contender->build(scene);
    sets = *make_ray_sets(scene, kSide, [&](std::span<const Ray> rays) {
      return trace_once(*contenders.front(), rays, Query::closest);
    });
  }
};

class EveryScene : public testing::TestWithParam<const char*> {};

TEST_P(EveryScene, SetsAreFullAndStartOnSurfaces) {
  const World world(GetParam());
  ASSERT_EQ(world.sets.size(), 4u);
  for (const RaySet& set : world.sets) {
    EXPECT_EQ(set.rays.size(), static_cast<std::size_t>(kSide * kSide)) << set.name;
    for (const Ray& ray : set.rays) {
      ASSERT_TRUE(is_finite(ray.origin) && is_finite(ray.direction));
      ASSERT_LT(ray.t_min, ray.t_max);
    }
  }
}

TEST_P(EveryScene, ContendersFindTheSameHits) {
  const World world(GetParam());
  const auto finder = [&](std::size_t i) {
    return [&, i](std::span<const Ray> rays) {
      return trace_once(*world.contenders[i], rays, Query::closest);
    };
  };
  for (const RaySet& set : world.sets) {
    const auto own = trace_once(*world.contenders[0], set.rays, set.query);
    for (std::size_t other = 1; other < world.contenders.size(); ++other) {
      for (const auto& tracer : world.contenders[other]->tracers(set.rays, set.query)) {
        tracer->reset();
        tracer->trace();
        const Agreement result = set.query == Query::closest
                                     ? compare_closest(world.scene, set.rays, own, tracer->found())
                                     : compare_any(world.scene, set.rays, own, tracer->found(),
                                                   finder(0), finder(other));
        EXPECT_EQ(result.a_wrong, 0u) << set.name << ", " << tracer->name();
        EXPECT_EQ(result.b_wrong, 0u) << set.name << ", " << tracer->name();
        EXPECT_GT(result.same, set.rays.size() * 99 / 100) << set.name << ", " << tracer->name();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene,
                         testing::Values("nice", "irreg:40", "rgbbox:6", "spheres:1500"));

}  // namespace
}  // namespace dapple::bench
