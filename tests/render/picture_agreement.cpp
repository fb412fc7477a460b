#include "tests/render/picture_agreement.h"

#include "render/camera_rays.h"
#include "render/classic_paths.h"

namespace dapple::test {

PictureStatistics rendered_picture(const Scene& scene, const RenderSettings& settings) {
  const PreparedScene prepared(scene, make_accel(AccelKind::fast, scene));
  const auto camera = CameraRays::create(scene.camera, settings);
  const ClassicPaths paths(prepared, camera.value(), settings);
  const Tile whole{0, 0, settings.width, settings.height};
  PictureStatistics picture(settings.width, settings.height);
  for (int sample = 0; sample < settings.samples_per_pixel; ++sample) {
    TileOutput output{TileSums(whole), std::nullopt};
    paths.render({sample, sample + 1}, output);
    for (std::size_t pixel = 0; pixel < picture.pixel_count(); ++pixel) {
      Channels value;
      for (std::size_t c = 0; c < 3; ++c) {
        value[c] = static_cast<double>(output.colour.sums()[pixel][c]) / double{kFilmStepsPerUnit};
      }
      picture.add(pixel, value);
    }
  }
  picture.set_sample_count(settings.samples_per_pixel);
  return picture;
}

PictureAgreement agreement_with_reference(const Scene& scene, const ReferenceSettings& size) {
  RenderSettings settings;
  settings.width = size.width;
  settings.height = size.height;
  settings.samples_per_pixel = size.samples;
  return compare_pictures(rendered_picture(scene, settings), reference_picture(scene, size));
}

::testing::AssertionResult agree(const PictureAgreement& agreement, std::size_t tests) {
  if (agreement.p_value() > corrected_significance(tests)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << agreement;
}

}  // namespace dapple::test
