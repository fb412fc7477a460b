// The pictures of the library against those of the reference tracer, by z-tests.
#include <gtest/gtest.h>

#include "render/render_job.h"
#include "scene/named_scenes.h"
#include "tests/render/picture_agreement.h"
#include "tests/render/picture_cases.h"

namespace dapple::test {
namespace {

class Picture : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Picture, AgreesWithTheReference) { check_picture(GetParam(), 1); }

INSTANTIATE_TEST_SUITE_P(Scenes, Picture, ::testing::Range(std::size_t{0}, kPictureCaseCount));

// The samples that statistics look at are those of the picture.
TEST(Pictures, TheSamplesAreThoseOfTheRendering) {
  const Scene scene = make_named_scene("nice").value();
  RenderSettings settings;
  settings.width = 37;
  settings.height = 41;
  settings.samples_per_pixel = 9;
  const PictureStatistics samples = rendered_picture(scene, settings);
  const PreparedScene prepared(scene, make_accel(AccelKind::fast, scene));
  const auto result = render(prepared, settings);
  ASSERT_TRUE(result);
  for (std::size_t pixel = 0; pixel < samples.pixel_count(); ++pixel) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_EQ(result->image.pixels[pixel][c],
                static_cast<float>(samples.mean(pixel, static_cast<std::size_t>(c))));
    }
  }
}

}  // namespace
}  // namespace dapple::test
