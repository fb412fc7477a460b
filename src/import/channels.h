// Pictures put together from channels of others.
#pragma once

#include "image/raw_image.h"

namespace dapple {

// One opaque white pixel.
[[nodiscard]] RawImage white_picture();

// The colours of one picture and, as alpha, the red of the other, in 8 bits and the larger of the
// two sizes. Floating-point pictures count from 0 to 1.
[[nodiscard]] RawImage with_alpha(const RawImage& colour, const RawImage& alpha);

// Roughness from the red of one to green, metallic from the red of the other to blue.
[[nodiscard]] RawImage roughness_and_metallic(const RawImage& roughness, const RawImage& metallic);

// True when most of its pixels, read as vectors, are about unit length and point outwards.
[[nodiscard]] bool looks_like_normals(const RawImage& picture);

}  // namespace dapple
