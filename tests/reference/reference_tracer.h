// A slow path tracer in double precision, written from the description of the classic picture and
// sharing nothing with the library but the scene: the oracle that its pictures are held against.
#pragma once

#include <cstdint>

#include "scene/scene.h"
#include "tests/reference/triple.h"
#include "tests/statistics/picture_statistics.h"

namespace dapple::test {

// The numbers of the description can be made wrong, to show that a comparison would notice.
struct ReferenceSettings {
  int width = 32;
  int height = 24;
  int samples = 1000;
  std::uint64_t seed = 1;
  int most_scatterings = 5;
  Triple cut = {1, 1, 1};
  Triple sky_below = {1, 1, 1};
  Triple sky_above = {0.5, 0.7, 1};
};

[[nodiscard]] PictureStatistics reference_picture(const Scene& scene,
                                                  const ReferenceSettings& settings);

}  // namespace dapple::test
