// A thin-lens camera, as the file says it.
#pragma once

#include "math/vec3.h"

namespace dapple {

struct Camera {
  Vec3d look_from{0, 0, 0};
  Vec3d look_at{0, 0, -1};
  Vec3d up{0, 1, 0};
  double vertical_fov = 75;  // degrees, in (0, 180)
  double aperture = 0.01;    // diameter of the lens
  double focus_distance = 10;
  friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace dapple
