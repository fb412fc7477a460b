// Numbers for random scenes, a function of a seed.
#pragma once

#include <cmath>
#include <cstdint>

#include "math/random.h"
#include "math/vec2.h"
#include "math/vec3.h"
#include "math/vec4.h"

namespace dapple::test {

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : seed_(seed) {}

  std::uint32_t below(std::uint32_t n) { return philox4x32({next_++, 0, 0, 0}, seed_)[0] % n; }
  double unit() { return below(1u << 30) * 0x1p-30; }
  float unitf() { return static_cast<float>(below(1u << 24)) * 0x1p-24f; }
  double coordinate() {
    switch (below(8)) {
      case 0:
        return 0.0;
      case 1:
        return -0.0;
      case 2:
        return 5e-324;
      case 3:
        return -1e18;
      case 4:
        return std::ldexp(unit() - 0.5, static_cast<int>(below(110)) - 50);
      default:
        return 200 * unit() - 100;
    }
  }
  Vec3d point() { return {coordinate(), coordinate(), coordinate()}; }
  Vec3d colour() { return {unit(), unit(), unit()}; }
  Vec3f colourf() { return {unitf(), unitf(), unitf()}; }
  Vec2f uv() { return {20 * unitf() - 10, unitf()}; }

  // Of length 1.
  Vec3f direction() {
    const Vec3f v(unitf() - 0.5f, unitf() - 0.5f, unitf() + 0.01f);
    return normalize(v);
  }
  // One in four has none.
  Vec3f normal() { return below(4) == 0 ? Vec3f() : direction(); }
  Vec4f tangent() {
    const Vec3f v = normal();
    return {v.x, v.y, v.z, below(2) == 0 ? 1.0f : -1.0f};
  }

 private:
  std::uint64_t seed_;
  std::uint32_t next_ = 0;
};

}  // namespace dapple::test
