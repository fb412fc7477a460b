// Random numbers of the textbook renderer: one small generator for each row of the picture.
#pragma once

#include <cmath>
#include <cstdint>

#include "math/vec3.h"

namespace dapple::textbook {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // Uniform in [0, 1): SplitMix64.
  double next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  double between(double low, double high) { return low + (high - low) * next(); }

 private:
  std::uint64_t state_;
};

// By rejection, as courses do it.
inline Vec3d random_in_unit_ball(Random& random) {
  for (;;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    if (x * x + y * y + z * z < 1) return {x, y, z};
  }
}

inline Vec3d random_in_unit_disc(Random& random) {
  for (;;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    if (x * x + y * y < 1) return {x, y, 0};
  }
}

}  // namespace dapple::textbook
