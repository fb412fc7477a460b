// What fills tiles with samples.
#pragma once

#include <optional>

#include "render/film.h"
#include "render/kernels/path_kernels.h"

namespace dapple {

// What a unit of work gives.
struct TileOutput {
  TileSums colour;
  std::optional<TileSums> alpha;  // in the first channel
  // Steps of radiance, of all channels, that the clamp of indirect light took away.
  std::int64_t clamped_steps = 0;
};

class Integrator {
 public:
  virtual ~Integrator() = default;

  // Adds the samples of the range to every pixel of the output's tile. May be called from many
  // threads at once. Throws std::length_error beyond kMostColumns, kMostRows or kMostSamples.
  virtual void render(SampleRange samples, TileOutput& output) const = 0;

  // How many paths it is best given at once: as many as the second-level cache holds.
  virtual std::int64_t paths_in_flight() const = 0;
};

}  // namespace dapple
