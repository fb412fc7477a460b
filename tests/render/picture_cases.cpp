#include "tests/render/picture_cases.h"

#include "scene/named_scenes.h"
#include "tests/render/picture_agreement.h"

namespace dapple::test {
namespace {

// Sizes are such that the reference, which tests every object, takes a second or two.
struct PictureCase {
  std::string name;
  Scene scene;
  int width, height, samples;
};

std::vector<PictureCase> picture_cases() {
  std::vector<PictureCase> cases;
  const auto named = [&](const char* name, int width, int height, int samples) {
    cases.push_back({name, make_named_scene(name).value(), width, height, samples});
  };
  named("empty", 40, 30, 1000);
  named("nice", 40, 30, 2000);
  named("irreg:50", 16, 12, 400);
  named("irreg:8", 24, 18, 1500);
  named("rgbbox", 24, 18, 600);
  named("spheres:200", 32, 24, 1000);
  for (const PictureScene& generated : picture_scenes()) {
    cases.push_back({generated.name, generated.scene, 36, 27, 2000});
  }
  return cases;
}

}  // namespace

void check_picture(std::size_t index, int factor) {
  const std::vector<PictureCase> cases = picture_cases();
  ASSERT_EQ(cases.size(), kPictureCaseCount);
  const PictureCase& c = cases[index];
  ReferenceSettings size;
  size.width = c.width;
  size.height = c.height;
  size.samples = c.samples * factor;
  const PictureAgreement agreement = agreement_with_reference(c.scene, size);
  EXPECT_TRUE(agree(agreement, kPictureCaseCount)) << c.name;
  ::testing::Test::RecordProperty("p_value", std::to_string(agreement.p_value()));
}

}  // namespace dapple::test
