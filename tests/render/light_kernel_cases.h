// Random arguments of the vector kernels of light paths.
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "accel/kernels/dispatch.h"
#include "math/warps.h"
#include "render/kernels/light_kernels.h"

namespace dapple::test {

inline constexpr std::size_t kCounts[] = {1, 17, kChunk};

// Runs on every level, with the best one left in use.
template <class Body>
void on_every_isa(const Body& body) {
  for (const std::string_view isa : available_isas()) {
    ASSERT_TRUE(force_isa(isa));
    SCOPED_TRACE(isa);
    body(light_kernels());
  }
  ASSERT_TRUE(force_isa(available_isas().front()));
}

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}

  float unit() { return std::uniform_real_distribution<float>(0, 0.9999999f)(random_); }
  float between(float lo, float hi) { return lo + unit() * (hi - lo); }
  std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
  std::uint32_t below(std::uint32_t n) { return word() % n; }
  bool once_in(std::uint32_t n) { return below(n) == 0; }
  Vec3f colour() { return {unit(), unit(), unit()}; }
  Vec3f direction() { return sample_uniform_sphere(unit(), unit()); }

 private:
  std::mt19937_64 random_;
};

inline Vec3f vector_at(const BsdfChunk::Vectors& arrays, std::size_t i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}

}  // namespace dapple::test
