#include "shading/studio.h"

#include <algorithm>
#include <array>

#include "math/functions.h"
#include "shading/colour.h"

namespace dapple {
namespace {

float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// A rectangle that faces the origin from distance 1, upright.
struct Softbox {
  Vec3f direction;
  float half_width, half_height;
  float radiance;

  float at(const Vec3f& d) const {
    const Vec3f n = normalize(direction);
    const Vec3f across = normalize(Vec3f(n.z, 0, -n.x));
    const Vec3f up = cross(n, across);
    const float depth = dot(d, n);
    if (!(depth > 0.1f)) return 0;
    const float x = std::fabs(dot(d, across)) / depth, y = std::fabs(dot(d, up)) / depth;
    constexpr float kEdge = 0.06f;  // softens the border
    const float inside = (1.0f - smooth_step(half_width - kEdge, half_width + kEdge, x)) *
                         (1.0f - smooth_step(half_height - kEdge, half_height + kEdge, y));
    // Bright in the middle, as cloth in front of a lamp is.
    const float fall = 1.0f - 0.25f * std::min(x * x + y * y, 1.0f);
    return radiance * inside * fall;
  }
};

constexpr std::array<Softbox, 4> kSoftboxes{{
    {{-1.0f, 0.75f, 0.9f}, 0.55f, 0.6f, 7.0f},
    {{1.3f, 0.45f, 0.6f}, 0.35f, 0.65f, 2.6f},
    {{0.5f, 0.65f, -1.2f}, 0.7f, 0.22f, 5.0f},
    {{0.02f, 1.0f, 0.05f}, 0.5f, 0.5f, 3.0f},
}};

constexpr float kExposure = 0.55f;  // shows a white floor just below white

float room(const Vec3f& d) {
  const float above = mix(0.42f, 0.62f, smooth_step(0.0f, 0.9f, d.y));
  const float below = mix(0.36f, 0.2f, smooth_step(0.0f, 0.8f, -d.y));
  return mix(below, above, smooth_step(-0.12f, 0.08f, d.y));
}

}  // namespace

std::vector<Vec3f> studio_pixels() {
  std::vector<Vec3f> pixels;
  pixels.reserve(std::size_t{kStudioWidth} * kStudioHeight);
  for (int y = 0; y < kStudioHeight; ++y) {
    const SinCos<float> polar =
        sin_cos_turns(0.5f * (static_cast<float>(y) + 0.5f) / float{kStudioHeight});
    for (int x = 0; x < kStudioWidth; ++x) {
      const SinCos<float> around =
          sin_cos_turns((static_cast<float>(x) + 0.5f) / float{kStudioWidth} - 0.5f);
      const Vec3f d(polar.sin * around.cos, polar.cos, polar.sin * around.sin);
      float radiance = room(d);
      for (const Softbox& box : kSoftboxes) radiance += box.at(d);
      pixels.push_back(grey(kExposure * radiance));
    }
  }
  return pixels;
}

}  // namespace dapple
