#include "render/path_sampler.h"

#include <algorithm>
#include <bit>

#include "math/sobol.h"

namespace dapple {
namespace {

// Puts zeros between the lower 16 bits.
std::uint32_t spread(std::uint32_t x) {
  x &= 0xffffu;
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

std::uint32_t low_bits(std::uint32_t x, int count) {
  return x & static_cast<std::uint32_t>((std::uint64_t{1} << count) - 1);
}

float to_unit(std::uint32_t word) { return static_cast<float>(word >> 8) * 0x1p-24f; }

}  // namespace

// 32 bits of index: the sample's, and as many as are left of the pixel's, at most 8 of each
// coordinate. Blocks of pixels beyond that are independent of each other.
PathSampler::PathSampler(int samples_per_pixel, std::uint64_t seed)
    : sample_bits_(static_cast<int>(
          std::bit_width(static_cast<std::uint32_t>(std::max(samples_per_pixel, 1) - 1)))),
      pixel_bits_(std::clamp((32 - sample_bits_) / 2, 0, 8)),
      seed_(seed) {}

PathSampler::Place PathSampler::place(std::uint32_t x, std::uint32_t y,
                                      std::uint32_t sample) const {
  const std::uint32_t morton = spread(low_bits(x, pixel_bits_)) | spread(low_bits(y, pixel_bits_))
                                                                      << 1;
  const std::uint32_t position = morton << sample_bits_ | sample;
  const auto seed_low = static_cast<std::uint32_t>(seed_);
  const auto seed_high = static_cast<std::uint32_t>(seed_ >> 32);
  Place place;
  place.block = mix(x >> pixel_bits_, mix(y >> pixel_bits_, seed_high)) ^ seed_low;
  place.reversed_position = reverse_bits(position << unused_bits());
  return place;
}

std::array<float, 4> PathSampler::uniform4(const Place& place, std::uint32_t dimension) const {
  const std::uint32_t sequence = mix(place.block, dimension);
  // The bits above those in use must stay zero, or the order would be shuffled beyond its end.
  const std::uint32_t index =
      owen_scramble_reversed(place.reversed_position, sequence) >> unused_bits();
  std::array<float, 4> u;
  for (int i = 0; i < kSobolDimensions; ++i) {
    const auto scramble = mix(sequence, static_cast<std::uint32_t>(i) + 1);
    u[static_cast<std::size_t>(i)] =
        to_unit(owen_scramble_reversed(reversed_sobol(index, i), scramble));
  }
  return u;
}

SamplerView PathSampler::view() const {
  return {sample_bits_, pixel_bits_, static_cast<std::uint32_t>(seed_),
          static_cast<std::uint32_t>(seed_ >> 32)};
}

}  // namespace dapple
