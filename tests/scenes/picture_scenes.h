// Scenes for pictures that named scenes do not cover: glass, every rectangle kind from both
// sides, a wide lens.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace dapple::test {

struct PictureScene {
  std::string name;
  Scene scene;
};

[[nodiscard]] Scene glass_scene();          // solid, hollow and thin glass over a matt floor
[[nodiscard]] Scene inside_glass_scene();   // the camera stands inside a glass sphere
[[nodiscard]] Scene rectangle_scene();      // a room of the three kinds, seen from both sides
[[nodiscard]] Scene wide_lens_scene();      // matt spheres before, in and behind the focus plane
[[nodiscard]] Scene tilted_camera_scene();  // up not perpendicular to the view, fuzz above one

// All of the above.
[[nodiscard]] std::vector<PictureScene> picture_scenes();

}  // namespace dapple::test
