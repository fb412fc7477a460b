// The picture of an environment and its distribution, as vector code reads them.
#pragma once

#include <cstdint>

#include "math/vec3.h"

namespace dapple {

// Texels top row first, either as three floats or, where that loses nothing, as RGBE in one word
// (image/rgbe.h), red in the lowest byte: a third of the memory, and what look-ups cost is waiting
// for memory.
struct EnvironmentView {
  const float* rgb = nullptr;
  const std::uint32_t* rgbe = nullptr;  // instead, if not null
  std::int32_t width = 0, height = 0;
  float turn = 0;  // rotation in turns
  Vec3f colour{1, 1, 1};
  // Those of PiecewiseConstant2d.
  const float* cdfs = nullptr;
  const std::uint32_t* guides = nullptr;
  std::uint32_t columns = 0, rows = 0;
};

}  // namespace dapple
