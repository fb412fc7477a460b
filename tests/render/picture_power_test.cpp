// That the comparison of pictures can fail: each of these mistakes must be found, at the sizes and
// levels at which the right pictures agree.
#include <gtest/gtest.h>

#include <functional>

#include "scene/named_scenes.h"
#include "tests/render/picture_agreement.h"

namespace dapple::test {
namespace {

constexpr std::size_t kTests = 11;

ReferenceSettings size_of_test() {
  ReferenceSettings size;
  size.width = 32;
  size.height = 24;
  size.samples = 800;
  return size;
}

PictureStatistics right_picture(const Scene& scene) {
  RenderSettings settings;
  settings.width = size_of_test().width;
  settings.height = size_of_test().height;
  settings.samples_per_pixel = size_of_test().samples;
  return rendered_picture(scene, settings);
}

// The library's picture of `scene` against a reference of which something is wrong.
void expect_found(const char* mistake, const Scene& scene,
                  const std::function<void(Scene&, ReferenceSettings&)>& spoil) {
  const PictureStatistics right = right_picture(scene);
  ReferenceSettings settings = size_of_test();
  EXPECT_TRUE(agree(compare_pictures(right, reference_picture(scene, settings)), kTests));
  Scene wrong = scene;
  spoil(wrong, settings);
  EXPECT_FALSE(agree(compare_pictures(right, reference_picture(wrong, settings)), kTests))
      << mistake;
}

TEST(PicturePower, NumberOfScatterings) {
  for (const int wrong : {4, 6}) {
    expect_found("cut too early or too late", glass_scene(),
                 [&](Scene&, ReferenceSettings& s) { s.most_scatterings = wrong; });
  }
}

TEST(PicturePower, ColourOfWhatIsCut) {
  expect_found("black in place of white", glass_scene(), [](Scene&, ReferenceSettings& s) {
    s.cut = {0, 0, 0};
  });
}

TEST(PicturePower, ColourOfTheSky) {
  const Scene empty = make_named_scene("empty").value();
  expect_found("one part in a thousand", empty, [](Scene&, ReferenceSettings& s) {
    s.sky_above = {0.5005, 0.7, 1};
  });
  expect_found("upside down", empty,
               [](Scene&, ReferenceSettings& s) { std::swap(s.sky_above, s.sky_below); });
}

TEST(PicturePower, Lens) {
  expect_found("no blur", wide_lens_scene(),
               [](Scene& scene, ReferenceSettings&) { scene.camera.aperture = 0; });
  expect_found("diameter taken for radius", wide_lens_scene(),
               [](Scene& scene, ReferenceSettings&) { scene.camera.aperture *= 2; });
}

TEST(PicturePower, FieldOfView) {
  expect_found("half a degree", make_named_scene("nice").value(),
               [](Scene& scene, ReferenceSettings&) { scene.camera.vertical_fov += 0.5; });
}

TEST(PicturePower, Materials) {
  const Scene nice = make_named_scene("nice").value();
  expect_found("fuzz", nice, [](Scene& scene, ReferenceSettings&) {
    std::get<Metal>(scene.materials[0]).fuzz = 0.8;
  });
  expect_found("albedo", nice, [](Scene& scene, ReferenceSettings&) {
    std::get<Lambertian>(scene.materials[2]).albedo = {0.8, 0.7, 0.8};
  });
  expect_found("refractive index", glass_scene(),
               [](Scene& scene, ReferenceSettings&) { scene.materials[0] = Dielectric{1.4}; });
  expect_found("hollow made solid", glass_scene(), [](Scene& scene, ReferenceSettings&) {
    scene.spheres[2].radius = -scene.spheres[2].radius;
  });
}

TEST(PicturePower, Geometry) {
  expect_found("a rectangle longer by a twentieth", rectangle_scene(),
               [](Scene& scene, ReferenceSettings&) { scene.rectangles[0][1].u1 += 0.05; });
}

}  // namespace
}  // namespace dapple::test
