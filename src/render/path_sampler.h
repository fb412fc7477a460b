// The random numbers of paths: scrambled Sobol points whose errors in neighbouring pixels differ,
// so that what noise is left looks like blue noise.
//
// Pixels are taken along a Morton curve and their samples one after the other; the whole order is
// shuffled hierarchically [AhmedWonka20] (here by Owen's scrambling of the index, in base 2), so
// that each pixel, and each aligned block of pixels, gets a well distributed part of one sequence.
// Every decision of a path has a sequence of its own [Burley20].
#pragma once

#include <array>
#include <cstdint>

#include "render/kernels/sampling_views.h"

namespace dapple {

class PathSampler {
 public:
  // `samples_per_pixel` is that of the whole picture; at least 1.
  PathSampler(int samples_per_pixel, std::uint64_t seed);

  // Where a sample of a pixel stands among all.
  struct Place {
    std::uint32_t block = 0;              // which sequence
    std::uint32_t reversed_position = 0;  // in it, with reversed bits
  };
  Place place(std::uint32_t x, std::uint32_t y, std::uint32_t sample) const;

  // Four numbers in [0, 1) for decision `dimension` of the sample at that place.
  std::array<float, 4> uniform4(const Place& place, std::uint32_t dimension) const;
  std::array<float, 4> uniform4(std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                                std::uint32_t dimension) const {
    return uniform4(place(x, y, sample), dimension);
  }

  SamplerView view() const;

 private:
  int unused_bits() const { return 32 - sample_bits_ - 2 * pixel_bits_; }

  int sample_bits_;
  int pixel_bits_;  // of each coordinate that share a sequence
  std::uint64_t seed_;
};

}  // namespace dapple
