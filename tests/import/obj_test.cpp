#include <gtest/gtest.h>

#include "import/obj/geometry.h"
#include "import/obj/mesh.h"
#include "import/obj/mtl.h"
#include "import/obj/smoothing.h"
#include "import/registry.h"
#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

using obj::kNone;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

void expect_error(const std::string& text, const std::string& place, const std::string& part) {
  const auto read = obj::read_geometry(text, "t.obj");
  ASSERT_FALSE(read) << text;
  EXPECT_EQ(read.error().code, Errc::bad_data);
  EXPECT_EQ(read.error().place, place);
  EXPECT_NE(read.error().message.find(part), std::string::npos) << read.error().message;
}

MeshData mesh_of(const std::string& text) {
  auto geometry = obj::read_geometry(text, "t.obj");
  EXPECT_TRUE(geometry) << to_string(geometry.error());
  obj::add_smooth_normals(*geometry);
  return obj::build_mesh(*geometry);
}

TEST(Obj, BadIndicesAreNamedWithTheirLine) {
  expect_error(kSquare + "f 0 1 2\n", "t.obj:5", "index 0");
  expect_error(kSquare + "f 1 2 5\n", "t.obj:5", "vertex 5 of 4");
  expect_error(kSquare + "f 1 2 -5\n", "t.obj:5", "-5 of 4");
  expect_error(kSquare + "f 1 2 99999999999999999999\n", "t.obj:5", "is not the index");
  expect_error(kSquare + "f 1 2 4294967296\n", "t.obj:5", "too far");
  expect_error(kSquare + "f 1 2 -9223372036854775808\n", "t.obj:5", "come before");
  expect_error(kSquare + "vt 0 0\nf 1/1 2/1 3/2\n", "t.obj:6", "texture coordinate 2 of 1");
  expect_error(kSquare + "vn 0 0 1\nf 1//1 2//1 3//2\n", "t.obj:6", "normal 2 of 1");
  expect_error(kSquare + "f 1 2 x\n", "t.obj:5", "'x'");
  expect_error("v 1 2\n", "t.obj:1", "three coordinates");
  expect_error("v 1 2 1e\n", "t.obj:1", "'1e'");
}

TEST(Obj, FacesWithIndicesOfNothingCanBeLeftOut) {
  const std::string text =
      "f 1 2 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 -4\nf 1/1 2/1 3/2\nf 1 0 2\n"
      "vt 0 0\nf 3 2 1\nl 1 2\nl 1 4\n";
  EXPECT_FALSE(obj::read_geometry(text, "t.obj"));
  const auto geometry = obj::read_geometry(text, "t.obj", true);
  ASSERT_TRUE(geometry) << to_string(geometry.error());
  EXPECT_EQ(geometry->broken_elements, 5u);
  EXPECT_NE(geometry->broken_reason.find("t.obj:6"), std::string::npos) << geometry->broken_reason;
  ASSERT_EQ(geometry->elements.size(), 3u);
  EXPECT_EQ(geometry->corners.size(), 8u);
  EXPECT_EQ(geometry->end_of(0), 3u);
  EXPECT_EQ(geometry->corners[3].position, 2u);
  EXPECT_EQ(geometry->elements[2].kind, obj::ElementKind::line);
}

TEST(Obj, AnIndexMayNameWhatComesLater) {
  const MeshData mesh = mesh_of("f 1 2 3\n" + kSquare);
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Obj, NegativeIndicesCountFromTheLatest) {
  const MeshData mesh = mesh_of(kSquare + "f -4 -3 -2\nv 5 5 5\nf -1 -4 -3\n");
  EXPECT_EQ(mesh.vertices.positions[mesh.triangles[0].vertices[0]], Vec3f(0, 0, 0));
  EXPECT_EQ(mesh.vertices.positions[mesh.triangles[1].vertices[0]], Vec3f(5, 5, 5));
  EXPECT_EQ(mesh.vertices.positions[mesh.triangles[1].vertices[1]], Vec3f(1, 0, 0));
}

TEST(Obj, CornersThatDifferInOneIndexAreDifferentVertices) {
  const std::string text = kSquare +
                           "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 0 -1\n"
                           "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\nf 1/2/1 2/1/2 3/1/1\n";
  const MeshData mesh = mesh_of(text);
  EXPECT_EQ(mesh.vertices.positions.size(), 6u);
  EXPECT_EQ(mesh.vertices.uvs[0].size(), 6u);
  EXPECT_EQ(mesh.vertices.normals.size(), 6u);
  EXPECT_EQ(mesh.triangles[0].vertices[0], mesh.triangles[1].vertices[0]);
  EXPECT_NE(mesh.triangles[0].vertices[0], mesh.triangles[2].vertices[0]);
}

TEST(Obj, TextureCoordinatesGrowDownwardsInAScene) {
  const MeshData mesh = mesh_of(kSquare + "vt 0.25 0.125\nf 1/1 2/1 3/1\n");
  EXPECT_EQ(mesh.vertices.uvs[0][0], (Vec2f{0.25f, 0.875f}));
}

TEST(Obj, SmoothingGroupsShareNormalsAndNothingElseDoes) {
  // A roof of two squares that meet at right angles in the edge 2-3.
  const std::string roof = "v -1 0 0\nv 0 1 0\nv 0 1 1\nv -1 0 1\nv 1 0 0\nv 1 0 1\n";
  const std::string faces[] = {"f 1 4 3 2\n", "f 2 3 6 5\n"};
  const auto ridge_normals = [&](const std::string& first, const std::string& second) {
    const MeshData mesh = mesh_of(roof + first + faces[0] + second + faces[1]);
    std::vector<Vec3f> normals;
    for (std::size_t i = 0; i < mesh.vertices.normals.size(); ++i) {
      if (mesh.vertices.positions[i] == Vec3f(0, 1, 0)) normals.push_back(mesh.vertices.normals[i]);
    }
    return normals;
  };
  const auto same = ridge_normals("s 1\n", "s 1\n");
  ASSERT_EQ(same.size(), 1u);
  EXPECT_NEAR(same[0].y, 1, 1e-6);
  const auto different = ridge_normals("s 1\n", "s 2\n");
  ASSERT_EQ(different.size(), 2u);
  for (const Vec3f& normal : different) EXPECT_NEAR(std::fabs(normal.x), std::sqrt(0.5), 1e-6);
  EXPECT_TRUE(ridge_normals("s off\n", "s 0\n").empty());
  const auto one = ridge_normals("s on\n", "s off\n");
  ASSERT_EQ(one.size(), 2u);
  EXPECT_TRUE(one[0] == Vec3f() || one[1] == Vec3f());
}

TEST(Obj, GivenNormalsStayAndBecomeUnit) {
  const MeshData mesh = mesh_of(kSquare + "vn 0 3 4\ns 1\nf 1//1 2//1 3//1\n");
  for (const Vec3f& normal : mesh.vertices.normals) EXPECT_EQ(normal, Vec3f(0, 0.6f, 0.8f));
}

TEST(Obj, LinesGoOnBehindABackslash) {
  const MeshData mesh = mesh_of("v 0 0 \\\n0\nv 1 0 0\nv 1 1 0\nf 1 \\\n 2 \\\n 3\n");
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_TRUE(obj::read_geometry("f \\", "t.obj"));
}

TEST(Obj, IndicesOfNormalsThatTheFileLeavesOutAreIgnoredWithAWarning) {
  const auto read = obj::read_geometry(kSquare + "f 1//1 2//2 3//3\n", "t.obj");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->warnings.size(), 1u);
  for (const obj::Corner& corner : read->corners) EXPECT_EQ(corner.normal, kNone);
}

class ObjFile : public testing::Test {
 protected:
  Expected<ImportResult> import(const std::string& obj, const std::string& mtl,
                                const ImportOptions& options = {}) {
    put_file(folder_ / "m.obj", obj);
    put_file(folder_ / "m.mtl", mtl);
    return import_scene(folder_ / "m.obj", options);
  }
  LayeredMaterial material(const std::string& mtl) {
    const auto result =
        import("mtllib m.mtl\n" + kSquare + "usemtl a\nf 1 2 3 4\n", "newmtl a\n" + mtl);
    EXPECT_TRUE(result) << to_string(result.error());
    if (!result) return {};
    const Scene& scene = result->scene;
    const Material& used = scene.materials[index_of(scene.triangle_materials[0])];
    return scene.layered_materials[std::get<Layered>(used).index];
  }

  TemporaryFolder folder_;
};

TEST_F(ObjFile, StandsInTheStudioUnlessItShines) {
  const auto plain = import(kSquare + "f 1 2 3 4\n", "");
  ASSERT_TRUE(plain) << to_string(plain.error());
  EXPECT_EQ(plain->scene.environment.kind, EnvironmentKind::studio);
  EXPECT_EQ(plain->scene.triangles.size(), 2u);
  const std::string lamp = "mtllib m.mtl\n" + kSquare + "usemtl lamp\nf 1 2 3 4\n";
  const auto shining = import(lamp, "newmtl lamp\nKe 5 5 5\n");
  ASSERT_TRUE(shining);
  EXPECT_EQ(shining->scene.environment.kind, EnvironmentKind::none);
}

TEST_F(ObjFile, MaterialsBecomeLayered) {
  const LayeredMaterial matte = material("Kd 0.1 0.2 0.3\nKs 0 0 0\n");
  EXPECT_EQ(matte.base_colour, Vec3f(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(matte.specular, 0);
  const LayeredMaterial shiny = material("Kd 1 1 1\nKs 1 1 1\nNs 1000\n");
  const LayeredMaterial dull = material("Kd 1 1 1\nKs 1 1 1\nNs 10\n");
  EXPECT_LT(shiny.roughness, dull.roughness);
  EXPECT_GT(shiny.roughness, 0);
  const LayeredMaterial mirror = material("Kd 0 0 0\nKs 0.9 0.8 0.7\nillum 3\n");
  EXPECT_EQ(mirror.metallic, 1);
  EXPECT_EQ(mirror.base_colour, Vec3f(0.9f, 0.8f, 0.7f));
  const LayeredMaterial glass = material("Kd 0 0 0\nNi 1.45\nillum 7\n");
  EXPECT_EQ(glass.transmission, 1);
  EXPECT_EQ(glass.ior, 1.45f);
  const LayeredMaterial half = material("d 0.5\n");
  EXPECT_EQ(half.alpha, 0.5f);
  EXPECT_EQ(half.alpha_mode, AlphaMode::blend);
  EXPECT_EQ(material("Tr 0.25\n").alpha, 0.75f);
}

TEST_F(ObjFile, ThePbrExtensionCounts) {
  const LayeredMaterial m = material("Pr 0.2\nPm 0.3\nPs 0.4\nPc 0.5\nPcr 0.6\naniso 0.7\n");
  EXPECT_EQ(m.roughness, 0.2f);
  EXPECT_EQ(m.metallic, 0.3f);
  EXPECT_EQ(m.sheen_colour, Vec3f(0.4f, 0.4f, 0.4f));
  EXPECT_EQ(m.clearcoat, 0.5f);
  EXPECT_EQ(m.clearcoat_roughness, 0.6f);
  EXPECT_EQ(m.anisotropy, 0.7f);
}

TEST_F(ObjFile, AMissingTextureIsAnErrorOrMagenta) {
  const std::string obj = "mtllib m.mtl\n" + kSquare + "usemtl a\nf 1 2 3 4\n";
  const std::string mtl = "newmtl a\nmap_Kd -o 1 2 no such file.png\n";
  const auto refused = import(obj, mtl);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Errc::no_input);
  EXPECT_EQ(refused.error().place, folder_ / "m.mtl:2");
  EXPECT_NE(refused.error().message.find("no such file.png"), std::string::npos);
  ImportOptions keep_going;
  keep_going.keep_going = true;
  const auto kept = import(obj, mtl, keep_going);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->warnings.size(), 1u);
  ASSERT_EQ(kept->scene.images.size(), 1u);
  const std::vector<std::uint8_t> magenta = {255, 0, 255, 255};
  EXPECT_EQ(std::vector(kept->scene.texels.begin(), kept->scene.texels.begin() + 4), magenta);
}

TEST_F(ObjFile, ATextureOutsideTheFolderIsRefused) {
  TemporaryFolder other;
  put_file(other / "secret.png", "secret");
  const std::string obj = "mtllib m.mtl\n" + kSquare + "usemtl a\nf 1 2 3 4\n";
  const auto refused = import(obj, "newmtl a\nmap_Kd " + (other / "secret.png") + "\n");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("outside"), std::string::npos) << refused.error().message;
}

TEST_F(ObjFile, AMissingLibraryIsAWarning) {
  const auto result = import("mtllib none.mtl\n" + kSquare + "usemtl a\nf 1 2 3 4\n", "");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->warnings.size(), 2u);  // the library and the material
  EXPECT_NE(result->warnings[0].find(".obj:1: "), std::string::npos) << result->warnings[0];
  EXPECT_NE(result->warnings[0].find("none.mtl"), std::string::npos) << result->warnings[0];
}

TEST_F(ObjFile, PointsAndLinesAreShown) {
  const auto result = import(kSquare + "p 1 2 3 4\nl 1 2 3\n", "");
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->scene.spheres.size(), 4u);
  EXPECT_EQ(result->scene.cylinders.size(), 2u);
  EXPECT_GT(result->scene.spheres[0].radius, 0);
}

TEST_F(ObjFile, AFileThatShowsNothingIsAnError) {
  for (const std::string& text : {std::string(), kSquare, kSquare + "f 1 1 1\nf 1\n",
                                  std::string("v nan 0 0\nv inf 0 0\nv 1 1 1\nf 1 2 3\n")}) {
    const auto result = import(text, "");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Errc::bad_data);
  }
}

TEST(Mtl, DamageIsNamedWithItsLine) {
  const auto error = [](const std::string& text) {
    obj::MtlLibrary library;
    const auto read = obj::read_mtl(text, "t.mtl", library);
    return read ? std::string() : to_string(read.error());
  };
  EXPECT_NE(error("Kd 1 1 1\n").find("t.mtl:1"), std::string::npos);
  EXPECT_NE(error("newmtl a\nKd x\n").find("t.mtl:2"), std::string::npos);
  EXPECT_NE(error("newmtl a\nKd\n").find("t.mtl:2"), std::string::npos);
  EXPECT_NE(error("newmtl a\nKd nan 0 0\n").find("not a finite number"), std::string::npos);
  EXPECT_NE(error("newmtl a\nNs 1e999\n").find("not a finite number"), std::string::npos);
  EXPECT_NE(error("newmtl a\nmap_Kd -o 1\n").find("name of a file"), std::string::npos);
  EXPECT_EQ(error("newmtl a\nKd .5\nd -halo 0.5\n"), "");
}

TEST(Mtl, OptionsOfMapsStandAroundTheName) {
  obj::MtlLibrary library;
  const std::string text = "newmtl a\nmap_bump -imfchan r -clamp on a file.jpg -bm 1.5 -o 1 -s 2 3";
  ASSERT_TRUE(obj::read_mtl(text, "t.mtl", library));
  const obj::MtlMap& map = library.materials["a"].map(obj::MtlMapUse::bump);
  EXPECT_EQ(map.file, "a file.jpg");
  EXPECT_TRUE(map.clamp);
  EXPECT_EQ(map.strength, 1.5f);
  EXPECT_EQ(map.offset, (Vec2f{1, 0}));
  EXPECT_EQ(map.scale, (Vec2f{2, 3}));
}

}  // namespace
}  // namespace dapple
