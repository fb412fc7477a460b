#include "tests/architecture/include_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dapple::architecture {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(IncludeOrder, HoldsInThisRepository) {
  const SourceTree tree = read_source_tree(DAPPLE_SOURCE_DIR, {"src", "apps", "include"});
  ASSERT_TRUE(tree.contains("src/math/vec3.h"));
  EXPECT_THAT(include_violations(tree), IsEmpty());
}

TEST(IncludeOrder, DownwardIsFine) {
  const SourceTree tree = {{"src/math/ray.h", "#include \"util/error.h\"\n#include <vector>\n"},
                           {"src/util/error.h", ""},
                           {"src/accel/accel.cpp", "#include \"accel/accel.h\"\n"},
                           {"src/accel/accel.h", "#include \"math/ray.h\""}};
  EXPECT_THAT(include_violations(tree), IsEmpty());
}

TEST(IncludeOrder, UpwardIsReported) {
  const SourceTree tree = {{"src/math/ray.h", "int x;\n  # include \"scene/scene.h\"\n"},
                           {"src/scene/scene.h", ""}};
  EXPECT_THAT(include_violations(tree),
              ElementsAre("src/math/ray.h: scene/scene.h is not in a lower layer"));
}

TEST(IncludeOrder, ModulesOfOneLayerDoNotKnowEachOther) {
  const SourceTree tree = {{"src/accel/a.h", "#include \"shading/b.h\""},
                           {"src/shading/b.h", "#include \"accel/a.h\""}};
  EXPECT_EQ(include_violations(tree).size(), 2u);
}

TEST(IncludeOrder, LibraryDoesNotKnowItsUsers) {
  const SourceTree tree = {{"src/render/a.cpp", "#include \"common/help.h\""},
                           {"src/render/b.cpp", "#include \"tests/c.h\""},
                           {"src/render/c.cpp", "#include <dapple/scene_io.h>"},
                           {"src/capi/d.cpp", "#include <dapple/scene_io.h>"},
                           {"apps/common/help.h", ""},
                           {"include/dapple/scene_io.h", ""}};
  EXPECT_EQ(include_violations(tree).size(), 3u);
}

TEST(IncludeOrder, NewModuleNeedsAPlace) {
  EXPECT_THAT(include_violations({{"src/physics/a.h", ""}}),
              ElementsAre("src/physics/a.h: is in no known module"));
}

TEST(IncludeOrder, ProgramsStandOnTheLibrary) {
  const SourceTree tree = {{"apps/ray.cpp", "#include \"classic.h\"\n#include \"math/ray.h\"\n"},
                           {"apps/classic.h", ""},
                           {"apps/dapple/a.cpp", "#include \"bench/b.h\"\n"},
                           {"src/math/ray.h", ""}};
  EXPECT_THAT(include_violations(tree),
              ElementsAre("apps/dapple/a.cpp: bench/b.h is in neither src/ nor apps/"));
}

TEST(IncludeOrder, InstalledHeadersStandAlone) {
  const SourceTree tree = {
      {"include/dapple/a.h",
       "#include <stddef.h>\n#include <dapple/b.h>\n#include \"dapple/b.h\"\n"},
      {"include/dapple/b.h", "#include \"math/ray.h\"\n#include <fmt/format.h>\n"},
      {"src/math/ray.h", ""}};
  EXPECT_EQ(include_violations(tree).size(), 2u);
}

}  // namespace
}  // namespace dapple::architecture
