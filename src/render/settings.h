// What one rendering is asked to be.
#pragma once

#include <cstdint>

#include "render/pixel_filter.h"
#include "util/error.h"

namespace dapple {

inline constexpr int kMaxImageSide = 1 << 20;
inline constexpr std::int64_t kMaxPixelCount = std::int64_t{1} << 31;
// With the film's clamp, this many samples cannot overflow its sums.
inline constexpr int kMaxSamplesPerPixel = 1 << 24;

struct RenderSettings {
  int width = 800;
  int height = 600;
  int samples_per_pixel = 16;
  std::uint64_t seed = 0;
  int max_scatterings = 5;  // a path is cut after this many

  // Of scenes that are not classic ones (render/lit_scene.h):
  FilterKind filter = FilterKind::blackman_harris;
  bool transparent_background = false;  // the picture gets alpha, and its background none
  float clamp_indirect = 0;  // cut of what a path brings after its first scattering; 0: none
};

// A usage error unless every number is in its range.
[[nodiscard]] Status validate(const RenderSettings& settings);

}  // namespace dapple
