// Samplers and filters as vector code reads them.
#pragma once

#include <cstdint>

namespace dapple {

// PathSampler's, without its tables.
struct SamplerView {
  int sample_bits = 0, pixel_bits = 0;
  std::uint32_t seed_low = 0, seed_high = 0;

  constexpr int bits() const { return sample_bits + 2 * pixel_bits; }
};

// The inverse distribution of a pixel filter at `steps` + 1 equal steps, or nothing: uniform.
struct FilterView {
  const float* places = nullptr;
  int steps = 0;
};

}  // namespace dapple
