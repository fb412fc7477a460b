#include <gtest/gtest.h>

#include "import/ply/model.h"
#include "import/registry.h"
#include "tests/import/mesh_texts.h"
#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

Expected<ply::Model> read(const std::string& text) { return ply::read(as_bytes(text), "t.ply"); }

std::string ply_of(const std::string& elements, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "property list uchar int vertex_index\n";

std::string error_of(const std::string& text) {
  const auto model = read(text);
  return model ? "" : to_string(model.error());
}

TEST(Ply, DamageIsNamedWithItsPlace) {
  const std::string mesh = "element vertex 3\n" + kXyz + "element face 1\n" + kFaces;
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(error_of(ply_of(mesh, corners + "3 0 1 2\n")), "");
  EXPECT_NE(error_of("plx\n").find("t.ply:1"), std::string::npos);
  EXPECT_NE(error_of("ply\nformat ascii 2.0\n").find("t.ply:2"), std::string::npos);
  EXPECT_NE(error_of("ply\nelement vertex 1\n").find("ends within"), std::string::npos);
  EXPECT_NE(error_of(ply_of("property float x\n", "")).find("t.ply:3"), std::string::npos);
  EXPECT_NE(error_of(ply_of("element vertex -1\n", "")).find("t.ply:3"), std::string::npos);
  EXPECT_NE(error_of(ply_of("element face 9\n", "")).find("no properties"), std::string::npos);
  EXPECT_NE(error_of(ply_of(mesh, corners + "3 0 1 3\n")).find("vertex 3 of 3"), std::string::npos);
  EXPECT_NE(error_of(ply_of(mesh, corners + "3 0 1 3\n")).find("t.ply:13"), std::string::npos);
  EXPECT_NE(error_of(ply_of(mesh, corners + "3 0 1 -1\n")).find("vertex -1"), std::string::npos);
  EXPECT_NE(error_of(ply_of(mesh, corners + "3 0 1 1.5\n")).find("not an integer"),
            std::string::npos);
  EXPECT_NE(error_of(ply_of(mesh, corners + "200 0 1 1\n")).find("longer than"), std::string::npos);
  EXPECT_NE(error_of(ply_of(mesh, corners + "-3 0 1 2\n")).find("negative"), std::string::npos);
  EXPECT_NE(error_of(ply_of(mesh, "0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n")).find("t.ply:11"),
            std::string::npos);
}

TEST(Ply, FacesWithIndicesOfNothingCanBeLeftOut) {
  const std::string text = ply_of("element vertex 3\n" + kXyz + "element face 4\n" + kFaces,
                                  "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 7 1 9\n3 2 1 0\n3 0 -1 2\n");
  EXPECT_FALSE(read(text));
  const auto model = ply::read(as_bytes(text), "t.ply", true);
  ASSERT_TRUE(model) << to_string(model.error());
  EXPECT_EQ(model->mesh.triangles.size(), 2u);
  EXPECT_EQ(model->broken_faces, 2u);
  EXPECT_NE(model->broken_reason.find("t.ply:14: face 1 names vertex 7"), std::string::npos)
      << model->broken_reason;
}

TEST(Ply, ACountIsBelievedOnlyAsFarAsTheFileGoes) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string text = std::string("ply\nformat ") + format +
                             " 1.0\nelement vertex 2000000000\n" + kXyz + "end_header\n1 2 3\n";
    EXPECT_NE(error_of(text).find("too short"), std::string::npos) << format;
    const std::string end = "t.ply, byte " + std::to_string(text.size()) + ": ";
    EXPECT_TRUE(error_of(text).starts_with(end)) << error_of(text);
  }
}

TEST(Ply, AttributesAreFoundByName) {
  const std::string elements =
      "element vertex 3\nproperty uchar red\nproperty double x\nproperty float y\nproperty float "
      "z\n"
      "property uchar green\nproperty uchar blue\nproperty float nx\nproperty float ny\n"
      "property float nz\nproperty float s\nproperty float t\nproperty int label\n"
      "element face 1\n" +
      kFaces;
  const auto model = read(ply_of(elements,
                                 "255 0 0 0 0 128 0 0 2 0.25 0.75 7\n"
                                 "255 1 0 0 0 128 0 0 2 0.25 0.75 7\n"
                                 "255 0 1 0 0 128 0 0 2 0.25 0.75 7\n3 0 1 2\n"));
  ASSERT_TRUE(model) << to_string(model.error());
  const Vertices& vertices = model->mesh.vertices;
  EXPECT_EQ(vertices.positions[1], Vec3f(1, 0, 0));
  EXPECT_EQ(vertices.normals[0], Vec3f(0, 0, 1));
  EXPECT_EQ(vertices.uvs[0][0], (Vec2f{0.25f, 0.25f}));
  EXPECT_EQ(vertices.colours[0].x, 1);
  EXPECT_EQ(vertices.colours[0].y, 0);
  EXPECT_NEAR(vertices.colours[0].z, 0.2159, 1e-4);  // 128 of sRGB
  EXPECT_EQ(model->ignored, std::vector<std::string>{"vertex property label"});
}

TEST(Ply, PolygonsAndStripsBecomeTriangles) {
  const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const auto polygon = read(ply_of("element vertex 4\n" + kXyz + "element face 2\n" + kFaces,
                                   square + "4 0 1 2 3\n2 0 1\n"));
  ASSERT_TRUE(polygon);
  EXPECT_EQ(polygon->mesh.triangles.size(), 2u);
  EXPECT_EQ(polygon->skipped_faces, 1u);
  const auto strip = read(ply_of(
      "element vertex 4\n" + kXyz + "element tristrips 1\nproperty list int int vertex_indices\n",
      square + "8 0 1 3 2 -1 0 1 2\n"));
  ASSERT_TRUE(strip) << to_string(strip.error());
  const std::vector<Triangle> expected = {{{0, 1, 3}}, {{3, 1, 2}}, {{0, 1, 2}}};
  EXPECT_EQ(strip->mesh.triangles, expected);
}

class PlyCloud : public testing::Test {
 protected:
  Expected<ImportResult> import(const std::string& text, double radius = 0) {
    put_file(folder_ / "c.ply", text);
    ImportOptions options;
    options.point_radius = radius;
    return import_scene(folder_ / "c.ply", options);
  }
  TemporaryFolder folder_;
};

TEST_F(PlyCloud, PointsAreSpheresOfTheirColour) {
  const std::string elements = "element vertex 3\n" + kXyz +
                               "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const auto result =
      import(ply_of(elements, "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 255 0 0\n"), 0.25);
  ASSERT_TRUE(result) << to_string(result.error());
  const Scene& scene = result->scene;
  ASSERT_EQ(scene.spheres.size(), 3u);
  EXPECT_EQ(scene.spheres[1], (Sphere{{1, 0, 0}, 0.25}));
  EXPECT_EQ(scene.sphere_materials[0], scene.sphere_materials[2]);
  const auto& green = std::get<Lambertian>(scene.materials[index_of(scene.sphere_materials[1])]);
  EXPECT_EQ(green.albedo, Vec3d(0, 1, 0));
  EXPECT_EQ(scene.environment.kind, EnvironmentKind::studio);
}

TEST_F(PlyCloud, RadiiComeFromTheOptionThenTheFileThenTheSpacing) {
  const std::string elements = "element vertex 2\n" + kXyz + "property float radius\n";
  const std::string cloud = ply_of(elements, "0 0 0 0.1\n1 0 0 0.2\n");
  EXPECT_EQ(import(cloud, 0.5)->scene.spheres[1].radius, 0.5);
  EXPECT_FLOAT_EQ(static_cast<float>(import(cloud)->scene.spheres[1].radius), 0.2f);
  const auto plain = import(ply_of("element vertex 2\n" + kXyz, "0 0 0\n1 0 0\n"));
  ASSERT_TRUE(plain);
  EXPECT_GT(plain->scene.spheres[0].radius, 0);
  EXPECT_LT(plain->scene.spheres[0].radius, 0.5);
}

TEST_F(PlyCloud, PointsThatAreNotFiniteAreLeftOutAndCounted) {
  const auto result = import(ply_of("element vertex 3\n" + kXyz, "0 0 0\nnan 0 0\n1e30 0 0\n"), 1);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->scene.spheres.size(), 1u);
  ASSERT_EQ(result->warnings.size(), 1u);
  EXPECT_NE(result->warnings[0].find("2 points"), std::string::npos);
}

}  // namespace
}  // namespace dapple
