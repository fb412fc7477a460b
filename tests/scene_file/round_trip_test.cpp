// What is stored is what is loaded, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "parallel/parallel.h"
#include "scene/named_scenes.h"
#include "scene/scene_arrays.h"
#include "scene_file/verify.h"
#include "scene_file/writer.h"
#include "tests/scene_file/random_model.h"
#include "tests/scene_file/random_scene.h"
#include "tests/scene_file/scene_bytes.h"
#include "tests/scene_file/small_bvh.h"

namespace dapple {
namespace {

void expect_round_trip(const SceneView& scene) {
  const test::AlignedBytes file(test::scene_bytes(scene));
  for (const bool hashes : {true, false}) {
    const auto loaded = verify(file.bytes(), {hashes, VerifyScope::everything});
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    EXPECT_TRUE(loaded->shapes_verified);
    EXPECT_TRUE(test::same_scene(scene, loaded->view));
  }
}

TEST(RoundTrip, RandomScenes) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    expect_round_trip(test::random_scene(seed, seed * seed % 97));
  }
}

TEST(RoundTrip, RandomModels) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    expect_round_trip(test::random_model(seed));
  }
}

// So that the tests of random models are tests of every array.
TEST(RoundTrip, RandomModelsHaveEverything) {
  std::array<std::size_t, kSceneArrayCount> scenes_with{};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Scene scene = test::random_model(seed);
    for_each_array(
        [&](SceneArray array, const auto& elements) {
          scenes_with[static_cast<std::size_t>(array)] += elements.empty() ? 0 : 1;
        },
        scene);
  }
  for (std::size_t i = 0; i < kSceneArrayCount; ++i) {
    EXPECT_GT(scenes_with[i], 20u) << element_name(static_cast<SceneArray>(i));
  }
}

TEST(RoundTrip, ACopyOfAViewIsTheScene) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Scene scene = test::random_model(seed);
    EXPECT_TRUE(copy_of(scene) == scene);
    EXPECT_TRUE(test::same_scene(copy_of(scene), scene));
  }
}

TEST(RoundTrip, AttributesOfManyChunks) {
  // Elements of 12 bytes lie across the ends of the pieces in which sections are hashed.
  const Scene scene = test::large_mesh(300);
  expect_round_trip(scene);
}

TEST(RoundTrip, RandomScenesWithTreesOfAllShapes) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = test::random_scene(seed, 1 + seed * seed % 397);
    const auto bvh = test::build_small_bvh(scene, 2 + seed % 15, 1 + seed % 16);
    SceneView view = scene;
    view.bvh = bvh.view();
    expect_round_trip(view);
  }
}

TEST(RoundTrip, ShapesOfPictures) {
  Scene scene = *make_named_scene("nice");
  scene.cameras.resize(3);
  const PictureShape shapes[] = {
      {}, {{{1152, 864}}, {}}, {{}, {0, 1.5, 1e-9}}, {{{1, kMaxFilmSide}}, {2, 0, 1e300}}};
  for (const PictureShape& shape : shapes) {
    const test::AlignedBytes file(test::scene_bytes(scene, shape));
    const auto loaded = verify(file.bytes());
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    EXPECT_EQ(loaded->pictures, shape);
    EXPECT_TRUE(test::same_scene(loaded->view, scene));
  }
}

TEST(RoundTrip, NamedScenes) {
  for (const NamedScene& named : named_scenes()) {
    const Scene scene = *make_named_scene(named.name);
    expect_round_trip(scene);
    const auto bvh = test::build_small_bvh(scene, 16, 8);
    SceneView view = scene;
    view.bvh = bvh.view();
    expect_round_trip(view);
  }
}

TEST(RoundTrip, SectionsOfManyChunksAndRuns) {
  Scene scene = *make_named_scene("spheres:100000");
  for (int i = 0; i < 80'000; ++i) {  // runs of one object, over a mebibyte of them
    const double x = i;
    scene.add_rectangle(rectangle_kind(static_cast<std::size_t>(i) % 3), {x, x + 1, 0, 1, x},
                        scene.add_material(Dielectric{1 + 1e-6 * x}));
  }
  const auto bvh = test::build_small_bvh(scene, 16, 16);
  SceneView view = scene;
  view.bvh = bvh.view();
  expect_round_trip(view);
}

TEST(RoundTrip, ObjectOrderAndSharedMaterialsAreKept) {
  const Scene scene = *make_named_scene("nice");
  const test::AlignedBytes file(test::scene_bytes(scene));
  const auto loaded = verify(file.bytes());
  ASSERT_TRUE(loaded);
  std::vector<ShapeKind> order;
  for_each_object(loaded->view, [&](ShapeKind kind, std::size_t) { order.push_back(kind); });
  const std::vector expected = {ShapeKind::yz_rectangle, ShapeKind::yz_rectangle, ShapeKind::sphere,
                                ShapeKind::xy_rectangle};
  EXPECT_EQ(order, expected);
  const Scene shared = *make_named_scene("irreg");
  EXPECT_EQ(test::FileParts(test::scene_bytes(shared)).section(SectionType::materials).entry.count,
            1u);
}

TEST(Writer, RefusesCompactLeaves) {
  const Scene scene = *make_named_scene("nice");
  auto bvh = test::build_small_bvh(scene, 16, 16);
  SceneView view = scene;
  view.bvh = bvh.view();
  EXPECT_TRUE(write_scene_bytes(view, [](auto) { return Status(); }));
  view.bvh.form = LeafForm::compact;
  const auto status = write_scene_bytes(view, [](auto) { return Status(); });
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Errc::usage);
}

TEST(Writer, SameBytesOnAnyNumberOfThreads) {
  const Scene scene = *make_named_scene("spheres:150000");
  const auto expected = test::scene_bytes(scene);
  for (const int threads : {1, 2, 3, 7}) {
    set_thread_count(threads);
    EXPECT_EQ(test::scene_bytes(scene), expected);
  }
  set_thread_count(0);
}

TEST(Writer, AFileIsHardlyLargerThanItsArrays) {
  const Scene scene = *make_named_scene("spheres:10000");
  const std::size_t arrays = scene.spheres.size() * sizeof(Sphere) +
                             scene.sphere_materials.size() * sizeof(MaterialId) +
                             scene.materials.size() * sizeof(Material);
  EXPECT_LE(static_cast<double>(test::scene_bytes(scene).size()),
            1.01 * static_cast<double>(arrays));
}

TEST(Writer, RefusesWhatAReaderWouldRefuse) {
  const auto expect_refused = [](const SceneView& scene) {
    std::size_t written = 0;
    const auto count = [&](std::span<const std::byte> bytes) -> Status {
      written += bytes.size();
      return {};
    };
    EXPECT_FALSE(write_scene_bytes(scene, count));
    EXPECT_EQ(written, 0u);
  };
  Scene far = *make_named_scene("nice");
  far.spheres[0].centre.y = 1.1e18;
  expect_refused(far);
  Scene lost = *make_named_scene("nice");
  lost.sphere_materials[0] = MaterialId{4};
  expect_refused(lost);
  const Scene scene = *make_named_scene("rgbbox");
  auto bvh = test::build_small_bvh(scene);
  SceneView view = scene;
  view.bvh = bvh.view();
  bvh.rows[0].words[0] ^= 1;  // no longer the sphere it was
  expect_refused(view);
}

TEST(Writer, AnErrorOfTheSinkEndsIt) {
  int calls = 0;
  const auto status = write_scene_bytes(*make_named_scene("nice"), [&](auto) -> Status {
    return ++calls == 3 ? Status(fail(Errc::io, "sink", "full")) : Status();
  });
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Errc::io);
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace dapple
