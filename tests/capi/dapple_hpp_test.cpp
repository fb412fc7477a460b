// The C++ interface, through the shared library and its public headers only.
#include <dapple/scene_io.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <dapple/dapple.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

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

// A square of two triangles in the plane y = 0, from -1 to 1.
struct Square {
  std::vector<float> positions = {-1, 0, -1, 1, 0, -1, -1, 0, 1, 1, 0, 1};
  std::vector<float> uvs = {0, 0, 1, 0, 0, 1, 1, 1};
  std::vector<float> normals = {0, 3, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
  std::vector<std::uint32_t> triangles = {0, 2, 1, 1, 2, 3};

  dapple::Mesh mesh() const { return {positions, triangles}; }
  dapple::Mesh painted() const { return {positions, triangles, normals, uvs, {}}; }
};

TEST_F(CppInterface, MeshesAreHit) {
  dapple::Scene scene = ball_on_floor();
  const Square square;
  const auto paint = scene.add_material(dapple::Layered{.base_colour = {1, 0, 0}, .metallic = 1});
  ASSERT_TRUE(paint) << paint.error().message;
  ASSERT_TRUE(scene.add_mesh(square.painted(), *paint));
  EXPECT_EQ(scene.object_count(), 4u);
  const auto accelerator = dapple::Accelerator::build(scene);
  ASSERT_TRUE(accelerator);
  // Outside the ball's shadow, and on either side of the diagonal.
  const dapple::Ray rays[] = {ray_down(-0.9f, -0.8f), ray_down(0.9f, 0.8f)};
  dapple::Hit hits[2];
  ASSERT_TRUE(accelerator->intersect(rays, hits));
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_FLOAT_EQ(hits[i].t, 10.0f);
    EXPECT_EQ(hits[i].shape, dapple::Shape::triangle);
    EXPECT_EQ(hits[i].index, i);
    EXPECT_EQ(hits[i].instance, dapple::no_instance);
  }
}

TEST_F(CppInterface, InstancesAreHitWhereTheyArePlaced) {
  dapple::Scene scene;
  const Square square;
  const auto grey = scene.add_material(dapple::Lambertian{{0.5, 0.5, 0.5}});
  const auto tile = scene.add_prototype(square.mesh(), *grey);
  ASSERT_TRUE(tile);
  for (int i = 0; i < 3; ++i) {
    dapple::Transform to_world;
    to_world.rows[0][3] = static_cast<float>(4 * i);
    to_world.rows[1][3] = static_cast<float>(i);
    ASSERT_TRUE(scene.add_instance(*tile, to_world));
  }
  for (const auto kind : {dapple::Accelerator::Kind::linear, dapple::Accelerator::Kind::fast}) {
    const auto accelerator = dapple::Accelerator::build(scene, kind);
    ASSERT_TRUE(accelerator);
    const dapple::Ray rays[] = {ray_down(0.5f, 0.75f), ray_down(4.5f, 0.75f), ray_down(8.5f, 0.75f),
                                ray_down(2, 0)};
    dapple::Hit hits[4];
    ASSERT_TRUE(accelerator->intersect(rays, hits));
    for (std::uint32_t i = 0; i < 3; ++i) {
      EXPECT_EQ(hits[i].t, 10.0f - static_cast<float>(i));
      EXPECT_EQ(hits[i].shape, dapple::Shape::triangle);
      EXPECT_EQ(hits[i].index, 1u);
      EXPECT_EQ(hits[i].instance, i);
    }
    EXPECT_FALSE(hits[3].found());
  }
}

// What was added in any order is stored, opened and stored again as the same bytes.
TEST_F(CppInterface, ModelsAreSaved) {
  dapple::Scene scene = ball_on_floor();
  const Square square;
  const std::vector<std::uint8_t> texels = {255, 0, 0, 255, 0, 255, 0, 255};
  const std::vector<float> sky(3 * 2 * 1, 0.5f);
  const auto image = scene.add_texture(2, 1, texels);
  const auto map = scene.add_texture(2, 1, sky);
  ASSERT_TRUE(image);
  ASSERT_TRUE(map);
  const auto paint = scene.add_material(dapple::Layered{.alpha = 0.5, .base_colour_map = *image});
  ASSERT_TRUE(paint);
  const auto tile = scene.add_prototype(square.painted(), *paint);
  ASSERT_TRUE(tile);
  ASSERT_TRUE(scene.add_mesh(square.mesh(), *paint));  // stands before the prototype
  for (int i = 0; i < 3; ++i) {
    dapple::Transform to_world;
    to_world.rows[0][3] = static_cast<float>(3 * i);
    ASSERT_TRUE(scene.add_instance(*tile, to_world));
  }
  ASSERT_TRUE(scene.add_cylinder({0, 0, 0}, {0, 1, 0}, 0.1, *paint));
  ASSERT_TRUE(scene.add_light({.direction = {0, -5, 0}, .intensity = {2, 2, 2}}));
  ASSERT_TRUE(scene.set_environment(
      {.kind = dapple::Environment::Kind::image, .image = *map, .rotation = 30}));
  EXPECT_EQ(scene.object_count(), 2u + 2 + 3 + 1);
  ASSERT_TRUE(scene.save(path("model.scene")));
  const auto opened = dapple::Scene::open(path("model.scene"));
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->object_count(), scene.object_count());
  ASSERT_TRUE(opened->save(path("again.scene")));
  const auto bytes_of = [&](const std::string& name) {
    std::ifstream file(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(bytes_of("model.scene"), bytes_of("again.scene"));
  EXPECT_GT(bytes_of("model.scene").size(), 1000u);
}

// The structs of the C interface have no room for a model.
TEST_F(CppInterface, TheCInterfaceRefusesWhatItCannotSay) {
  const Square square;
  const auto expect_refused = [&](const dapple::Scene& scene, const std::string& reason) {
    ASSERT_TRUE(scene.save(path("model.scene")));
    EXPECT_EQ(load_scene(path("model.scene").c_str()), nullptr);
    EXPECT_NE(std::string(scene_io_last_error()).find(reason), std::string::npos)
        << scene_io_last_error();
    EXPECT_NE(std::string(scene_io_last_error()).find("model.scene"), std::string::npos);
  };
  dapple::Scene mesh = ball_on_floor();
  ASSERT_TRUE(mesh.add_mesh(square.mesh(), dapple::MaterialId{0}));
  expect_refused(mesh, "triangles");
  dapple::Scene cylinder = ball_on_floor();
  ASSERT_TRUE(cylinder.add_cylinder({0, 0, 0}, {0, 1, 0}, 1, dapple::MaterialId{0}));
  expect_refused(cylinder, "cylinders");
  dapple::Scene layered = ball_on_floor();
  const auto paint = layered.add_material(dapple::Layered{});
  ASSERT_TRUE(layered.add_sphere({0, 0, 0}, 1, *paint));
  expect_refused(layered, "layered materials");
  dapple::Scene light = ball_on_floor();
  ASSERT_TRUE(light.add_light({}));
  expect_refused(light, "lights");
  dapple::Scene studio = ball_on_floor();
  ASSERT_TRUE(studio.set_environment({.kind = dapple::Environment::Kind::studio}));
  expect_refused(studio, "environment");
  ASSERT_TRUE(ball_on_floor().save(path("plain.scene")));
  struct loaded_scene* plain = load_scene(path("plain.scene").c_str());
  EXPECT_NE(plain, nullptr);
  free_loaded_scene(plain);
}

TEST_F(CppInterface, ModelsThatAreNoneChangeNothing) {
  dapple::Scene scene = ball_on_floor();
  const dapple::MaterialId grey{0};
  const auto expect_refused = [](const auto& result, const std::string& reason) {
    ASSERT_FALSE(result) << reason;
    EXPECT_EQ(result.error().code, 65) << reason;
    EXPECT_NE(result.error().message.find(reason), std::string::npos) << result.error().message;
  };
  Square square;
  square.triangles[4] = 4;
  expect_refused(scene.add_mesh(square.mesh(), grey), "triangle 1: a vertex index");
  square = {};
  expect_refused(scene.add_mesh(square.mesh(), dapple::MaterialId{9}), "material");
  square.positions[7] = std::nanf("");
  expect_refused(scene.add_mesh(square.mesh(), grey), "vertex position 2");
  square = {};
  square.uvs.pop_back();
  expect_refused(scene.add_prototype(square.painted(), grey), "sizes");
  square.triangles.clear();
  expect_refused(scene.add_prototype(square.mesh(), grey), "no triangles");
  expect_refused(scene.add_instance(dapple::PrototypeId{0}, {}), "prototype does not exist");
  square = {};
  const auto tile = scene.add_prototype(square.mesh(), grey);
  ASSERT_TRUE(tile);
  dapple::Transform flat;
  flat.rows[1][1] = 0;
  expect_refused(scene.add_instance(*tile, flat), "transform");
  expect_refused(scene.add_material(dapple::Layered{.roughness = 1.5}), "roughness");
  expect_refused(scene.add_material(dapple::Layered{.normal_map = dapple::TextureId{0}}),
                 "texture");
  expect_refused(scene.add_texture(2, 2, std::vector<std::uint8_t>(15)), "texture");
  expect_refused(scene.add_texture(-1, -1, std::vector<float>(3)), "texture");
  expect_refused(scene.add_light({.direction = {0, 0, 0}}), "direction");
  expect_refused(scene.add_light({.intensity = {-1, 0, 0}}), "intensity");
  expect_refused(scene.add_cylinder({0, 0, 0}, {0, 0, 1}, -1, grey), "cylinder");
  expect_refused(scene.set_environment({.kind = dapple::Environment::Kind::image}), "image");
  EXPECT_EQ(scene.object_count(), 2u);
  EXPECT_TRUE(scene.save(path("still.scene")));
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
