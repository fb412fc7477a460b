// A thin-lens camera, as the file says it.
#pragma once

#include <array>

#include "math/vec3.h"

namespace dapple {

struct Camera {
  Vec3d look_from{0, 0, 0};
  Vec3d look_at{0, 0, -1};
  Vec3d up{0, 1, 0};
  double vertical_fov = 75;  // degrees, in (0, 180)
  double aperture = 0.01;    // diameter of the lens
  double focus_distance = 10;
  double orthographic_height = 0;  // what the picture's height spans; 0: in perspective
  friend bool operator==(const Camera&, const Camera&) = default;
};

// One of the cameras that a scene offers.
struct NamedCamera {
  std::array<char, 64> name{};  // UTF-8, cut to 63 bytes, padded with zeros
  Camera camera;
  friend bool operator==(const NamedCamera&, const NamedCamera&) = default;
};

}  // namespace dapple
