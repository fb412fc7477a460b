// Cameras for scenes that come without one, or that are to be seen from elsewhere.
#pragma once

#include <optional>

#include "math/bounds3.h"
#include "scene/camera.h"

namespace dapple {

// A camera on a sphere around a target: theta turns it about +y from +z towards +x, phi is the
// angle from +y (90: level). Degrees; the radius in the scene's unit, above 0.
struct Orbit {
  double theta = 30;
  double phi = 70;
  double radius = 1;
};

inline constexpr double kFramingFov = 45;  // degrees, vertical

// Looks at `target` from the orbit; sharp everywhere.
[[nodiscard]] Camera orbit_camera(const Orbit& orbit, const Vec3d& target, double vertical_fov);

// A three-quarter view in which the whole box is seen in a picture of this shape. An empty box is
// looked at from a distance of 1.
[[nodiscard]] Camera frame_scene(const Bounds3f& bounds, double width_over_height,
                                 double vertical_fov = kFramingFov);

}  // namespace dapple
