#include "tests/architecture/house_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dapple::architecture {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

SourceTree whole_tree() {
  return read_source_tree(
      DAPPLE_SOURCE_DIR,
      {"src", "apps", "include", "tests", "bench", "fuzz", "docs", "cmake", "tools", "data",
       "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "CMakePresets.json", "run"});
}

TEST(HouseRules, HoldInThisRepository) {
  const SourceTree tree = whole_tree();
  ASSERT_TRUE(tree.contains("src/math/vec3.h"));
  EXPECT_THAT(naming_violations(tree), IsEmpty());
  EXPECT_THAT(length_violations(tree), IsEmpty());
  EXPECT_THAT(forbidden_calls(tree), IsEmpty());
  EXPECT_THAT(citation_violations(tree), IsEmpty());
  EXPECT_THAT(broken_links(tree), IsEmpty());
}

TEST(HouseRules, Names) {
  EXPECT_THAT(
      naming_violations({{"src/math/a_b2.cpp", ""},
                         {"src/accel/kernels/simd-inl.h", ""},
                         {"src/math/Vec.cpp", ""},
                         {"src/math/ray.h", "int x;"}}),
      ElementsAre("src/math/Vec.cpp: is not named in snake_case", "src/math/ray.h: has no guard"));
}

TEST(HouseRules, Lengths) {
  SourceTree tree;
  for (int i = 0; i < 19; ++i) tree["src/a" + std::to_string(i) + ".cpp"] = "";
  tree["src/long.cpp"] = std::string(400, '\n');
  EXPECT_THAT(length_violations(tree), IsEmpty());
  tree["src/long2.cpp"] = tree["src/long3.cpp"] = tree["src/long.cpp"];
  EXPECT_EQ(length_violations(tree).size(), 3u);
}

TEST(HouseRules, ForbiddenCalls) {
  const auto offends = [](const std::string& line, const std::string& file = "src/scene/a.cpp") {
    return !forbidden_calls({{file, line}}).empty();
  };
  EXPECT_TRUE(offends("  std::cerr << x;"));
  EXPECT_TRUE(offends("  fmt::print(stderr, x);"));
  EXPECT_FALSE(offends("  fmt::format(x);"));
  EXPECT_FALSE(offends("  snprintf(x);"));
  EXPECT_TRUE(offends("  exit(1);"));
  EXPECT_FALSE(offends("  on_exit_path(1);"));
  EXPECT_TRUE(offends("#pragma omp parallel"));
  EXPECT_FALSE(offends("#pragma omp parallel", "src/parallel/a.cpp"));
  EXPECT_TRUE(offends("#include <hwy/highway.h>", "src/accel/a.cpp"));
  EXPECT_FALSE(offends("#include <hwy/highway.h>", "src/accel/kernels/a.cpp"));
  EXPECT_TRUE(offends("y = std::pow(x, 2);"));
  EXPECT_FALSE(offends("y = std::sqrt(x);"));
  EXPECT_FALSE(offends("// unlike std::pow(x, 2)"));
}

TEST(HouseRules, Citations) {
  EXPECT_THAT(citation_violations({{"docs/references.bib", "@book{Knuth97,\n}\n@book{Gauss09,\n}"},
                                   {"src/math/a.h",
                                    "// ["
                                    "Knuth97] and ["
                                    "Euler44]\nint x[Ga"
                                    "uss09];"}}),
              ElementsAre("src/math/a.h: no entry for Euler44",
                          "docs/references.bib: nobody cites Gauss09"));
}

TEST(HouseRules, Links) {
  EXPECT_THAT(broken_links({{"docs/a.md", "[b](b.md#part) [c](../README.md) [d](https://x.org)"},
                            {"docs/b.md", "[up](../docs) ![p](images/p.png \"title\")"},
                            {"README.md", "[a](docs/a.md)"}}),
              ElementsAre("docs/b.md: images/p.png"));
}

}  // namespace
}  // namespace dapple::architecture
