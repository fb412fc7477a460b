// What importers add comes out whole, once, and in the order that a scene wants.
#include "import/scene_builder.h"

#include <gtest/gtest.h>

#include <limits>

namespace dapple {
namespace {

constexpr std::uint64_t kPlenty = 1 << 30;

MeshData one_triangle(float x, MaterialId material) {
  MeshData mesh;
  mesh.vertices.positions = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}};
  mesh.triangles = {{{0, 1, 2}}};
  mesh.materials = {material};
  return mesh;
}

RawImage grey_image(std::uint8_t level) {
  return {2, 1, RawFormat::rgba8, std::vector<std::uint8_t>(8, level)};
}

TEST(SceneBuilder, EqualThingsAreStoredOnce) {
  SceneBuilder builder(kPlenty);
  LayeredMaterial red;
  red.base_colour = {1, 0, 0};
  EXPECT_EQ(builder.add_material(red), builder.add_material(red));
  EXPECT_NE(builder.add_material(red), builder.add_material(LayeredMaterial()));
  EXPECT_EQ(builder.add_image(grey_image(1)).value(), builder.add_image(grey_image(1)).value());
  EXPECT_NE(builder.add_image(grey_image(1)).value(), builder.add_image(grey_image(2)).value());
  const auto scene = builder.finish("");
  ASSERT_TRUE(scene.has_value());
  EXPECT_EQ(scene->layered_materials.size(), 2u);
  ASSERT_EQ(scene->images.size(), 2u);
  for (const TextureImage& image : scene->images) {
    EXPECT_EQ(image.offset % 16, 0u);
    EXPECT_LE(image.offset + image.bytes(), scene->texels.size());
  }
}

TEST(SceneBuilder, PrototypesTileTheTailOfTheTriangles) {
  SceneBuilder builder(kPlenty);
  const MaterialId material = builder.add_material({});
  const auto first = builder.add_prototype(one_triangle(10, material));
  ASSERT_TRUE(builder.add_mesh(one_triangle(0, material)).has_value());
  const auto second = builder.add_prototype(one_triangle(20, material));
  ASSERT_TRUE(first && second);
  ASSERT_TRUE(builder.add_instance(*second, {}).has_value());
  const auto scene = builder.finish("");
  ASSERT_TRUE(scene.has_value());
  ASSERT_EQ(scene->prototypes.size(), 2u);
  EXPECT_EQ(scene->prototypes[*first], (Prototype{1, 1}));
  EXPECT_EQ(scene->prototypes[*second], (Prototype{2, 1}));
  const auto x_of = [&](std::size_t triangle) {
    return scene->vertices.positions[scene->triangles[triangle].vertices[0]].x;
  };
  EXPECT_EQ(x_of(0), 0);
  EXPECT_EQ(x_of(1), 10);
  EXPECT_EQ(x_of(2), 20);
}

TEST(SceneBuilder, AttributesOfSomeMeshesAreFilledForTheOthers) {
  SceneBuilder builder(kPlenty);
  const MaterialId material = builder.add_material({});
  MeshData with = one_triangle(0, material);
  with.vertices.normals.assign(3, {0, 0, 1});
  with.vertices.colours.assign(3, {0.5f, 0.5f, 0.5f, 1});
  ASSERT_TRUE(builder.add_mesh(one_triangle(0, material)).has_value());
  ASSERT_TRUE(builder.add_mesh(with).has_value());
  ASSERT_TRUE(builder.add_mesh(one_triangle(0, material)).has_value());
  const auto scene = builder.finish("");
  ASSERT_TRUE(scene.has_value());
  ASSERT_EQ(scene->vertices.normals.size(), 9u);
  EXPECT_EQ(scene->vertices.normals[0], Vec3f());
  EXPECT_EQ(scene->vertices.normals[3], Vec3f(0, 0, 1));
  EXPECT_EQ(scene->vertices.normals[6], Vec3f());
  ASSERT_EQ(scene->vertices.colours.size(), 9u);
  EXPECT_EQ(scene->vertices.colours[8], (Vec4f{1, 1, 1, 1}));
  EXPECT_TRUE(scene->vertices.tangents.empty());
}

TEST(SceneBuilder, TrianglesThatCannotBeSeenAreCounted) {
  SceneBuilder builder(kPlenty);
  const MaterialId material = builder.add_material({});
  MeshData mesh = one_triangle(0, material);
  mesh.vertices.positions.push_back({std::numeric_limits<float>::quiet_NaN(), 0, 0});
  mesh.vertices.positions.push_back({1e19f, 0, 0});
  mesh.triangles.push_back({{0, 1, 1}});
  mesh.triangles.push_back({{0, 1, 3}});
  mesh.triangles.push_back({{0, 1, 4}});
  mesh.materials.assign(4, material);
  ASSERT_TRUE(builder.add_mesh(mesh).has_value());
  EXPECT_EQ(builder.left_out().without_area, 1u);
  EXPECT_EQ(builder.left_out().not_finite, 2u);
  mesh.triangles.push_back({{0, 1, 5}});
  mesh.materials.push_back(material);
  EXPECT_FALSE(builder.add_mesh(mesh).has_value());
}

TEST(SceneBuilder, CamerasAreChosenByNameThenByIndex) {
  const auto chosen = [](const std::string& wanted) {
    SceneBuilder builder(kPlenty);
    Camera camera;
    camera.vertical_fov = 30;
    builder.add_camera("1", camera);
    camera.vertical_fov = 60;
    builder.add_camera("left", camera);
    const auto scene = builder.finish(wanted);
    return scene ? scene->camera.vertical_fov : 0;
  };
  EXPECT_EQ(chosen(""), 30);
  EXPECT_EQ(chosen("left"), 60);
  EXPECT_EQ(chosen("1"), 30);
  EXPECT_EQ(chosen("0"), 30);
  EXPECT_EQ(chosen("2"), 0);
  EXPECT_EQ(chosen("right"), 0);
  EXPECT_EQ(chosen("0x"), 0);
}

TEST(SceneBuilder, MemoryIsLimited) {
  SceneBuilder builder(100);
  const MaterialId material = builder.add_material({});
  EXPECT_FALSE(builder.add_mesh(one_triangle(0, material)).has_value());
}

}  // namespace
}  // namespace dapple
