// Rays of a thin-lens camera, in perspective or parallel.
#pragma once

#include <array>
#include <cstdint>

#include "math/ray.h"
#include "render/settings.h"
#include "scene/camera.h"

namespace dapple {

// The numbers that rays are made of.
struct CameraFrame {
  Vec3f origin;
  Vec3f corner;      // from the origin to the top left corner of the picture, on the focus plane
  Vec3f per_column;  // one pixel to the right
  Vec3f per_row;     // one pixel down
  Vec3f lens_u, lens_v;
  Vec3f forward;              // from the origin to the centre of the focus plane
  bool orthographic = false;  // rays are parallel to `forward`
};

class CameraRays {
 public:
  // An error when the camera's axes are degenerate: it looks at where it stands, or along `up`; and
  // when its lens is focused nearer or farther than below.
  [[nodiscard]] static Expected<CameraRays> create(const Camera& camera,
                                                   const RenderSettings& settings);

  // The ray through point (u[0], u[1]) of pixel (x, y), row 0 at the top, from the point of the
  // lens that u[2] and u[3] choose. Its direction reaches the focus plane at t = 1. A point outside
  // [0, 1) lies in a neighbouring pixel.
  Ray generate(int x, int y, const std::array<float, 4>& u) const;
  const CameraFrame& frame() const { return frame_; }

 private:
  CameraRays() = default;

  CameraFrame frame_;
};

// The block of four random numbers of a sample that its camera ray uses.
inline constexpr std::uint32_t kCameraDimension = 0;

// Between these, squares of a ray's coordinates are well within the range of floats.
inline constexpr double kNearestFocus = 1e-15, kFarthestFocus = 1e15;

// Distances along a ray below this, in units of its direction, are not hits.
inline constexpr float kRayTMin = 1e-3f;

}  // namespace dapple
