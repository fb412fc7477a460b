// The C++ interface, through the shared library and its public headers only.
#include <dapple/scene_io.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <dapple/dapple.hpp>

#include <cmath>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

class CppInterface : public testing::Test {
 protected:
  CppInterface() {
    std::string pattern = (fs::temp_directory_path() / "dapple_hpp_test.XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~CppInterface() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

// A unit sphere at the origin and a square one below it.
dapple::Scene ball_on_floor() {
  dapple::Scene scene;
  const auto grey = scene.add_material(dapple::Lambertian{{0.8, 0.8, 0.8}});
  const auto glass = scene.add_material(dapple::Dielectric{1.5});
  EXPECT_TRUE(scene.add_sphere({0, 0, 0}, 1, *glass));
  EXPECT_TRUE(scene.add_rectangle(dapple::Shape::xz_rectangle, {-3, 3, -3, 3, -1}, *grey));
  EXPECT_TRUE(scene.set_camera({.look_from = {0, 2, 5}, .look_at = {0, 0, 0}}));
  return scene;
}

dapple::Ray ray_down(float x, float z) {
  dapple::Ray ray;
  ray.origin[0] = x;
  ray.origin[1] = 10;
  ray.origin[2] = z;
  ray.direction[1] = -1;
  ray.direction[2] = 0;
  return ray;
}

TEST_F(CppInterface, RaysFindWhatIsThereWithEveryAccelerator) {
  using Kind = dapple::Accelerator::Kind;
  for (const Kind kind : {Kind::linear, Kind::median, Kind::fast}) {
    const auto accelerator = dapple::Accelerator::build(ball_on_floor(), kind);
    ASSERT_TRUE(accelerator);
    const dapple::Ray rays[] = {ray_down(0, 0), ray_down(2, 2), ray_down(9, 9)};
    dapple::Hit hits[3];
    std::uint8_t occluded[3];
    ASSERT_TRUE(accelerator->intersect(rays, hits));
    ASSERT_TRUE(accelerator->occluded(rays, occluded));
    EXPECT_EQ(hits[0].t, 9.0f);
    EXPECT_EQ(hits[0].shape, dapple::Shape::sphere);
    EXPECT_EQ(hits[1].t, 11.0f);
    EXPECT_EQ(hits[1].shape, dapple::Shape::xz_rectangle);
    EXPECT_EQ(hits[1].index, 0u);
    EXPECT_FALSE(hits[2].found());
    EXPECT_EQ(occluded[0] + 2 * occluded[1] + 4 * occluded[2], 3);
  }
}

TEST_F(CppInterface, StreamsOfAnyLength) {
  const auto accelerator = dapple::Accelerator::build(*dapple::Scene::open("irreg"));
  std::vector<dapple::Ray> rays;
  for (int i = 0; i < 1000; ++i) {
    rays.push_back(ray_down(-300 + 12 * static_cast<float>(i % 50), -300));
  }
  std::vector<dapple::Hit> hits(rays.size());
  ASSERT_TRUE(accelerator->intersect(rays, hits));
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(hits[i].t, 4.0f);
    EXPECT_EQ(hits[i].index, 50 * (i % 50));
  }
  hits.pop_back();
  EXPECT_FALSE(accelerator->intersect(rays, hits));
  EXPECT_TRUE(accelerator->intersect({}, {}));
}

TEST_F(CppInterface, SavedScenesOpenAndRenderAlike) {
  const auto named = dapple::Scene::open("rgbbox");
  ASSERT_TRUE(named);
  const dapple::RenderOptions options{.width = 40, .height = 30, .samples_per_pixel = 2, .seed = 5};
  const auto expected = dapple::render(*dapple::Accelerator::build(*named), options);
  ASSERT_TRUE(expected);
  EXPECT_EQ(expected->rgb.size(), 3u * 40 * 30);
  for (const auto contents :
       {dapple::Scene::Contents::scene, dapple::Scene::Contents::scene_and_bvh}) {
    ASSERT_TRUE(named->save(path("saved.scene"), contents));
    const auto opened = dapple::Scene::open(path("saved.scene"));
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->object_count(), 400u);
    const auto picture = dapple::render(*dapple::Accelerator::build(*opened), options);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->rgb, expected->rgb);
  }
  EXPECT_TRUE(expected->save(path("picture.ppm")));
  EXPECT_GT(fs::file_size(path("picture.ppm")), 3u * 40 * 30);
}

TEST_F(CppInterface, CopiesAreValues) {
  dapple::Scene scene = ball_on_floor();
  const auto before = dapple::Accelerator::build(scene);
  const dapple::Scene copy = scene;
  const auto red = scene.add_material(dapple::Metal{{1, 0, 0}, 0});
  ASSERT_TRUE(red);
  ASSERT_TRUE(scene.add_sphere({9, 0, 9}, 1, *red));
  EXPECT_EQ(scene.object_count(), 3u);
  EXPECT_EQ(copy.object_count(), 2u);
  const dapple::Ray ray = ray_down(9, 9);
  dapple::Hit hit;
  ASSERT_TRUE(before->intersect({&ray, 1}, {&hit, 1}));
  EXPECT_FALSE(hit.found());
  ASSERT_TRUE(dapple::Accelerator::build(scene)->intersect({&ray, 1}, {&hit, 1}));
  EXPECT_EQ(hit.index, 1u);
}

TEST_F(CppInterface, OpenedScenesCanBeChanged) {
  ASSERT_TRUE(ball_on_floor().save(path("a"), dapple::Scene::Contents::scene_and_bvh));
  auto scene = dapple::Scene::open(path("a"));
  ASSERT_TRUE(scene);
  ASSERT_TRUE(scene->add_sphere({9, 0, 9}, 1, dapple::MaterialId{0}));
  ASSERT_TRUE(scene->save(path("b"), dapple::Scene::Contents::scene_and_bvh));
  EXPECT_EQ(dapple::Scene::open(path("b"))->object_count(), 3u);
  EXPECT_EQ(dapple::Scene::open(path("b"))->camera().look_from.z, 5);
}

TEST_F(CppInterface, ErrorsSayWhy) {
  dapple::Scene scene = ball_on_floor();
  EXPECT_FALSE(scene.add_sphere({NAN, 0, 0}, 1, dapple::MaterialId{0}));
  EXPECT_FALSE(scene.add_sphere({0, 0, 0}, 1, dapple::MaterialId{2}));
  EXPECT_FALSE(scene.add_rectangle(dapple::Shape::sphere, {}, dapple::MaterialId{0}));
  EXPECT_FALSE(scene.add_material(dapple::Dielectric{INFINITY}));
  EXPECT_FALSE(scene.set_camera({.vertical_fov = 180}));
  EXPECT_EQ(scene.object_count(), 2u);
  const auto missing = dapple::Scene::open(path("missing"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, 66);
  EXPECT_NE(missing.error().message.find("nice"), std::string::npos);
  const auto status = scene.save(path("no/folder"));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, 73);
  EXPECT_FALSE(dapple::render(*dapple::Accelerator::build(scene), {.width = 0}));
  EXPECT_FALSE(dapple::Picture{}.save(path("picture.ppm")));
}

TEST_F(CppInterface, AnEmptySceneIsFine) {
  const dapple::Scene scene;
  EXPECT_EQ(scene.object_count(), 0u);
  EXPECT_EQ(scene.camera().vertical_fov, 75);
  ASSERT_TRUE(scene.save(path("empty"), dapple::Scene::Contents::scene_and_bvh));
  EXPECT_EQ(dapple::Scene::open(path("empty"))->object_count(), 0u);
  EXPECT_TRUE(dapple::render(*dapple::Accelerator::build(scene), {.width = 4, .height = 4}));
}

TEST_F(CppInterface, WhatOneInterfaceStoresTheOtherLoads) {
  ASSERT_TRUE(ball_on_floor().save(path("a"), dapple::Scene::Contents::scene_and_bvh));
  loaded_scene* scene = load_scene(path("a").c_str());
  ASSERT_NE(scene, nullptr) << scene_io_last_error();
  EXPECT_EQ(scene_get_num_objects(scene), 2u);
  EXPECT_EQ(scene_get_objects(scene)[1].type, XZ_RECTANGLE);
  EXPECT_EQ(scene_get_lookfrom(scene)->y, 2);
  free_loaded_scene(scene);
}

}  // namespace
