// Files cut short and files with bits flipped are refused. Large files are sampled, unless the
// environment variable DAPPLE_TEST_EVERY_BIT is set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>

#include "scene/named_scenes.h"
#include "scene/validate.h"
#include "scene_file/verify.h"
#include "tests/scene_file/random_model.h"
#include "tests/scene_file/scene_bytes.h"
#include "tests/scene_file/small_bvh.h"

namespace dapple {
namespace {

// A named scene, or `model:SEED`, one that has everything.
Scene scene_of(const std::string& name) {
  if (name.starts_with("model:")) return test::random_model(std::stoul(name.substr(6)));
  return *make_named_scene(name);
}

struct Case {
  const char* scene;
  bool with_bvh;
  std::size_t step;  // 1: every truncation and every bit
};

void PrintTo(const Case& test_case, std::ostream* out) {
  *out << test_case.scene << (test_case.with_bvh ? " with BVH" : "");
}

class Damage : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    scene_ = scene_of(GetParam().scene);
    view_ = scene_;
    if (GetParam().with_bvh) {
      bvh_ = test::build_small_bvh(scene_, 16, 16);
      view_.bvh = bvh_.view();
    }
    file_ = test::scene_bytes(view_);
  }
  std::size_t step() const {
    return std::getenv("DAPPLE_TEST_EVERY_BIT") != nullptr ? 1 : GetParam().step;
  }

  Scene scene_;
  test::SmallBvh bvh_;
  SceneView view_;
  std::vector<std::byte> file_;
};

TEST_P(Damage, EveryTruncationIsRefused) {
  for (std::size_t size = 0; size < file_.size(); size += step()) {
    const test::AlignedBytes cut{std::span<const std::byte>(file_).first(size)};
    const auto loaded = verify(cut.bytes());
    ASSERT_FALSE(loaded) << "cut to " << size;
    ASSERT_EQ(loaded.error().code, Errc::bad_data);
    ASSERT_FALSE(verify(cut.bytes(), {false, VerifyScope::everything})) << "cut to " << size;
  }
}

TEST_P(Damage, EveryFlippedBitIsNoticed) {
  test::AlignedBytes file(file_);
  ASSERT_TRUE(verify(file.bytes()));
  for (std::size_t bit = 0; bit < 8 * file_.size(); bit += step()) {
    const auto mask = static_cast<std::byte>(1u << bit % 8);
    file[bit / 8] ^= mask;
    ASSERT_FALSE(verify(file.bytes())) << "bit " << bit;  // nothing in the file is without meaning
    file[bit / 8] ^= mask;
  }
}

// Without the checksums a flipped bit may give another scene, but nothing worse.
TEST_P(Damage, WithoutChecksumsEveryFlippedBitIsHarmless) {
  test::AlignedBytes file(file_);
  for (std::size_t bit = 0; bit < 8 * file_.size(); bit += step()) {
    const auto mask = static_cast<std::byte>(1u << bit % 8);
    file[bit / 8] ^= mask;
    const auto loaded = verify(file.bytes(), {false, VerifyScope::everything});
    if (loaded) {
      ASSERT_TRUE(validate(loaded->view)) << "bit " << bit;
    }
    file[bit / 8] ^= mask;
  }
}

TEST_P(Damage, AddedBytesAreRefused) {
  for (const std::size_t added : {1u, 63u, 64u, 4096u}) {
    std::vector<std::byte> longer = file_;
    longer.resize(file_.size() + added);
    EXPECT_FALSE(verify(test::AlignedBytes(longer).bytes()));
  }
}

// Steps without common factors with the sizes of fields: every kind of field is met at every bit.
INSTANTIATE_TEST_SUITE_P(NamedScenes, Damage,
                         testing::Values(Case{"empty", false, 1}, Case{"nice", false, 1},
                                         Case{"nice", true, 1}, Case{"rgbbox", false, 1},
                                         Case{"rgbbox", true, 5}, Case{"irreg", false, 229},
                                         Case{"irreg", true, 487}, Case{"spheres:5000", true, 4999},
                                         Case{"model:4", false, 3}, Case{"model:5", false, 3},
                                         Case{"model:6", false, 3}, Case{"model:7", false, 3}),
                         [](const auto& test_case) {
                           std::string name = test_case.param.scene;
                           std::replace(name.begin(), name.end(), ':', '_');
                           return name + (test_case.param.with_bvh ? "_with_bvh" : "");
                         });

}  // namespace
}  // namespace dapple
