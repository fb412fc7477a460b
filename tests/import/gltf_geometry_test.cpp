// The same shape comes out however a glTF file stores it, and stands where its nodes put it.
#include <gtest/gtest.h>

#include "scene/validate.h"
#include "tests/import/gltf_text.h"

namespace dapple {
namespace {

Vec3f corner(const Scene& scene, std::size_t triangle, std::size_t k) {
  return scene.vertices.positions[scene.triangles[triangle].vertices[k]];
}

Vec3f normal(const Scene& scene, std::size_t t) {
  return normalize(
      cross(corner(scene, t, 1) - corner(scene, t, 0), corner(scene, t, 2) - corner(scene, t, 0)));
}

Scene imported(const std::string& text, const ImportOptions& options = {}) {
  auto result = import_text(text, options);
  EXPECT_TRUE(result.has_value()) << (result ? "" : to_string(result.error()));
  return result ? std::move(result->scene) : Scene();
}

std::string mesh_text(const GltfText& file, const std::string& primitive) {
  return file.text(fmt::format(
      R"("extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":["KHR_mesh_quantization"],"meshes":[{{"primitives":[{{{}}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}])",
      primitive));
}

TEST(GltfGeometry, TransformsMoveTheTriangle) {
  const Scene scene = imported(one_triangle(
      R"(,"translation":[10,0,0],"rotation":[0,0,0.70710678,0.70710678],"scale":[2,3,1])"));
  ASSERT_EQ(scene.triangles.size(), 1u);
  EXPECT_NEAR(corner(scene, 0, 1).x, 10, 1e-5);
  EXPECT_NEAR(corner(scene, 0, 1).y, 2, 1e-5);
  EXPECT_NEAR(corner(scene, 0, 2).x, 7, 1e-5);
  EXPECT_EQ(scene.environment.kind, EnvironmentKind::studio);
  EXPECT_EQ(scene.camera.aperture, 0);
}

TEST(GltfGeometry, MirrorsKeepTheOutsideOutside) {
  for (const char* scale : {"-1,1,1", "1,-2,1", "-1,-1,1", "1,1,1"}) {
    const Scene scene = imported(one_triangle(fmt::format(R"(,"scale":[{}])", scale)));
    EXPECT_GT(normal(scene, 0).z, 0.99f) << scale;
  }
  EXPECT_LT(normal(imported(one_triangle(R"(,"scale":[1,1,-1])")), 0).z, -0.99f);
}

TEST(GltfGeometry, AMeshSeenTwiceIsStoredOnce) {
  GltfText file;
  const auto positions = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const Scene scene = imported(file.text(fmt::format(
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],"nodes":[{{"mesh":0}},{{"mesh":0,"translation":[5,0,0]}}],"scenes":[{{"nodes":[0,1]}}])",
      positions)));
  ASSERT_EQ(scene.prototypes.size(), 1u);
  EXPECT_EQ(scene.triangles.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[1].to_world.rows[0][3], 5);
}

TEST(GltfGeometry, AFlatInstanceIsSeenAsAFlatMeshIs) {
  GltfText file;
  const auto positions = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2});
  const auto indices = file.indices({0, 1, 2, 0, 2, 3});
  const auto result = import_text(file.text(fmt::format(
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{}}}]}}],"nodes":[{{"mesh":0}},{{"mesh":0,"translation":[5,0,0],"scale":[1,1,0]}},{{"mesh":0,"scale":[0,0,1]}}],"scenes":[{{"nodes":[0,1,2]}}])",
      positions, indices)));
  ASSERT_TRUE(result) << to_string(result.error());
  const Scene& scene = result->scene;
  EXPECT_EQ(scene.instances.size(), 1u);
  // One of its two triangles keeps an area.
  ASSERT_EQ(scene.triangles.size(), 3u);
  EXPECT_EQ(corner(scene, 0, 1), Vec3f(6, 0, 0));
  const std::string warnings = fmt::format("{}", fmt::join(result->warnings, "\n"));
  EXPECT_NE(warnings.find("1 triangles"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("1 of its instances are left out"), std::string::npos) << warnings;
}

TEST(GltfGeometry, EveryModeHasItsNumberOfPieces) {
  struct Case {
    int mode;
    std::size_t triangles, lines, points;
  };
  for (const Case c : {Case{0, 0, 0, 5}, Case{1, 0, 2, 0}, Case{2, 0, 5, 0}, Case{3, 0, 4, 0},
                       Case{4, 1, 0, 0}, Case{5, 3, 0, 0}, Case{6, 3, 0, 0}}) {
    GltfText file;
    // Five points that a strip and a fan both turn the same way round.
    const auto strip = file.vec3({0, 0, 0, 0, -1, 0, 1, 0.5, 0, 1.2f, -0.8f, 0, 2, 0.4f, 0});
    const auto fan = file.vec3({0, 0, 0, 1, -1, 0, 2, 0, 0, 2, 1, 0, 1, 2, 0});
    const Scene scene =
        imported(mesh_text(file, fmt::format(R"("mode":{},"attributes":{{"POSITION":{}}})", c.mode,
                                             c.mode == 6 ? fan : strip)));
    EXPECT_EQ(scene.triangles.size(), c.triangles) << c.mode;
    EXPECT_EQ(scene.cylinders.size(), c.lines) << c.mode;
    EXPECT_EQ(scene.spheres.size(), c.points) << c.mode;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      EXPECT_GT(normal(scene, t).z, 0) << "mode " << c.mode << ", triangle " << t;
    }
  }
}

// The corners (0,0,0) (1,0,0) (0,1,0), in every way that an accessor can say them.
TEST(GltfGeometry, EveryStorageGivesTheSameCorners) {
  GltfText file;
  const std::size_t plain = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::size_t bytes = file.values<std::uint8_t>({0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0},
                                                      "VEC3", 4, 5121, R"(,"normalized":true)");
  (void)bytes;
  const std::size_t strided_view =
      file.view<std::int16_t>({0, 0, 0, 9, 32767, 0, 0, 9, 0, 32767, 0, 9}, R"(,"byteStride":8)");
  const std::size_t shorts = file.accessor(fmt::format(
      R"("bufferView":{},"componentType":5122,"normalized":true,"count":3,"type":"VEC3")",
      strided_view));
  const std::size_t integers_view =
      file.view<std::int8_t>({0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9}, R"(,"byteStride":4)");
  const std::size_t integers = file.accessor(fmt::format(
      R"("bufferView":{},"componentType":5120,"count":3,"type":"VEC3")", integers_view));
  const std::size_t sparse_indices = file.view<std::uint16_t>({1, 2});
  const std::size_t sparse_values = file.view<float>({1, 0, 0, 0, 1, 0});
  const std::size_t sparse = file.accessor(fmt::format(
      R"("componentType":5126,"count":3,"type":"VEC3","sparse":{{"count":2,"indices":{{"bufferView":{},"componentType":5123}},"values":{{"bufferView":{}}}}})",
      sparse_indices, sparse_values));
  for (const std::size_t accessor : {plain, shorts, integers, sparse}) {
    const Scene scene =
        imported(mesh_text(file, fmt::format(R"("attributes":{{"POSITION":{}}})", accessor)));
    ASSERT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(corner(scene, 0, 0), Vec3f(0, 0, 0));
    EXPECT_EQ(corner(scene, 0, 1), Vec3f(1, 0, 0));
    EXPECT_EQ(corner(scene, 0, 2), Vec3f(0, 1, 0));
  }
}

TEST(GltfGeometry, MorphTargetsCountAsMuchAsTheirWeights) {
  GltfText file;
  const auto base = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto delta = file.vec3({0, 0, 4, 0, 0, 4, 0, 0, 4});
  const auto text = [&](const char* mesh, const char* node) {
    return file.text(fmt::format(
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}},"targets":[{{"POSITION":{}}}]}}]{}}}],"nodes":[{{"mesh":0{}}}],"scenes":[{{"nodes":[0]}}])",
        base, delta, mesh, node));
  };
  EXPECT_EQ(corner(imported(text("", "")), 0, 0).z, 0);
  EXPECT_EQ(corner(imported(text(R"(,"weights":[0.5])", "")), 0, 0).z, 2);
  EXPECT_EQ(corner(imported(text(R"(,"weights":[0.5])", R"(,"weights":[0.25])")), 0, 0).z, 1);
}

TEST(GltfGeometry, SkinsFollowTheirJointsAndNotTheNode) {
  GltfText file;
  const auto positions = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto joints =
      file.values<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 4, 5121);
  const auto weights =
      file.values<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 4, 5126);
  const Scene scene = imported(file.text(fmt::format(
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{},"JOINTS_0":{},"WEIGHTS_0":{}}}}}]}}],"skins":[{{"joints":[1,2]}}],"nodes":[{{"mesh":0,"skin":0,"translation":[100,0,0]}},{{"translation":[0,0,2]}},{{"translation":[0,0,4]}}],"scenes":[{{"nodes":[0,1,2]}}])",
      positions, joints, weights)));
  EXPECT_EQ(corner(scene, 0, 0), Vec3f(0, 0, 2));
  EXPECT_EQ(corner(scene, 0, 1), Vec3f(1, 0, 4));
  EXPECT_EQ(corner(scene, 0, 2), Vec3f(0, 1, 3));
}

TEST(GltfGeometry, AnimationsMoveNodesAtTheirTime) {
  for (const char* interpolation : {"LINEAR", "STEP", "CUBICSPLINE"}) {
    const bool cubic = std::string(interpolation) == "CUBICSPLINE";
    GltfText file;
    const auto positions = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const auto times = file.values<float>({1, 3}, "SCALAR", 1, 5126);
    const auto keys = cubic ? file.vec3({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0})
                            : file.vec3({0, 0, 0, 8, 0, 0});
    const std::string text = file.text(fmt::format(
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}],"animations":[{{"samplers":[{{"input":{},"output":{},"interpolation":"{}"}}],"channels":[{{"sampler":0,"target":{{"node":0,"path":"translation"}}}}]}}])",
        positions, times, keys, interpolation));
    const auto x_at = [&](double time) {
      ImportOptions options;
      options.time = time;
      return corner(imported(text, options), 0, 0).x;
    };
    EXPECT_EQ(x_at(0), 0) << interpolation;
    EXPECT_EQ(x_at(9), 8) << interpolation;
    EXPECT_EQ(x_at(2), interpolation[0] == 'S' ? 0 : 4) << interpolation;
    // A quarter of the way: 3 t^2 - 2 t^3 with flat tangents.
    EXPECT_FLOAT_EQ(x_at(1.5), cubic ? 8 * 0.15625f : interpolation[0] == 'L' ? 2 : 0);
  }
}

TEST(GltfGeometry, GpuInstancesAreInstances) {
  GltfText file;
  const auto positions = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto places = file.vec3({1, 0, 0, 2, 0, 0, 3, 0, 0});
  const Scene scene = imported(file.text(fmt::format(
      R"("extensionsUsed":["EXT_mesh_gpu_instancing"],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],"nodes":[{{"mesh":0,"translation":[0,7,0],"extensions":{{"EXT_mesh_gpu_instancing":{{"attributes":{{"TRANSLATION":{}}}}}}}}}],"scenes":[{{"nodes":[0]}}])",
      positions, places)));
  ASSERT_EQ(scene.instances.size(), 3u);
  EXPECT_EQ(scene.instances[2].to_world.point(Vec3f()), Vec3f(3, 7, 0));
}

}  // namespace
}  // namespace dapple
