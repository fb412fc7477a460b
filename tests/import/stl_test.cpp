#include <gtest/gtest.h>

#include "import/registry.h"
#include "import/stl/reader.h"
#include "tests/import/mesh_texts.h"
#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

std::string error_of(const std::string& text) {
  const auto model = stl::read(as_bytes(text), "t.stl");
  return model ? "" : to_string(model.error());
}

TEST(Stl, DamageIsNamedWithItsPlace) {
  EXPECT_NE(error_of("").find("t.stl"), std::string::npos);
  EXPECT_NE(error_of("facet\n").find("neither"), std::string::npos);
  EXPECT_NE(error_of("solid\nvertex 1 2\n").find("t.stl:2"), std::string::npos);
  EXPECT_NE(error_of("solid\nvertex 1 2 3\nendloop\n").find("fewer"), std::string::npos);
  EXPECT_NE(
      error_of("solid\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\n").find("more"),
      std::string::npos);
  EXPECT_NE(error_of("solid\nvertex 1 2 3\n").find("ends within"), std::string::npos);
  EXPECT_NE(error_of("solid\nfoo\n").find("'foo'"), std::string::npos);
}

TEST(Stl, AnyFirstWordMayBeginABinaryFile) {
  std::string bytes = as_stl_binary(bumpy_torus(4));
  const auto solid = stl::read(as_bytes(bytes), "t.stl");
  ASSERT_TRUE(solid);
  bytes.replace(0, 5, "other");
  const auto other = stl::read(as_bytes(bytes), "t.stl");
  ASSERT_TRUE(other);
  EXPECT_EQ(solid->mesh.triangles, other->mesh.triangles);
}

TEST(Stl, ABinaryFileThatIsCutShortIsNotTakenForText) {
  std::string bytes = as_stl_binary(bumpy_torus(4));
  ASSERT_TRUE(bytes.starts_with("solid"));
  bytes.resize(bytes.size() - 30);
  EXPECT_NE(error_of(bytes).find("t.stl, byte 80: the file promises"), std::string::npos)
      << error_of(bytes);
}

TEST(Stl, APromiseOfMoreFacetsIsNotBelieved) {
  std::string bytes = as_stl_binary(bumpy_torus(4));
  bytes[0] = 'x';
  bytes[83] = '\x7f';  // more than two billion
  EXPECT_NE(error_of(bytes).find("promises"), std::string::npos);
  EXPECT_NE(error_of(bytes).find("byte 80"), std::string::npos);
}

TEST(Stl, BytesBehindTheLastFacetAreAWarning) {
  std::string bytes = as_stl_binary(bumpy_torus(4)) + "more";
  bytes[0] = 'x';
  const auto model = stl::read(as_bytes(bytes), "t.stl");
  ASSERT_TRUE(model);
  EXPECT_EQ(model->warnings.size(), 1u);
}

TEST(Stl, BecomesASceneInTheStudio) {
  TemporaryFolder folder;
  put_file(folder / "t.stl", as_stl_binary(bumpy_torus(8)));
  const auto result = import_scene(folder / "t.stl", {});
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->scene.triangles.size(), 128u);
  EXPECT_EQ(result->scene.vertices.positions.size(), 64u);
  EXPECT_EQ(result->scene.environment.kind, EnvironmentKind::studio);
  EXPECT_TRUE(result->warnings.empty());
}

}  // namespace
}  // namespace dapple
