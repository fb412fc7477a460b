// Smaller copies of an image, each half the size of the one before.
#pragma once

#include <cstdint>
#include <vector>

#include "shading/texel_coding.h"

namespace dapple {

struct MipLevel {
  const std::uint8_t* texels = nullptr;
  TexelCoding coding = TexelCoding::rgba8_linear;
  std::int32_t width = 0, height = 0;
};

// One smaller level and its memory.
struct OwnedMipLevel {
  std::vector<std::uint8_t> storage;
  MipLevel level;
};

// Half the width and height, rounded down, at least 1. Each texel is the mean over the area that
// it covers, in linear light, also where that is 1.5 or 3 texels wide.
[[nodiscard]] OwnedMipLevel next_mip_level(const MipLevel& larger);

}  // namespace dapple
