// A picture in memory: linear RGB, single precision, top row first; alpha where there is any.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec3.h"
#include "util/unwritten_vector.h"

namespace dapple {

struct Image {
  using Pixels = UnwrittenVector<Vec3f>;  // Pixels(n) are not black but unwritten

  int width = 0;
  int height = 0;
  Pixels pixels;             // width * height; already multiplied by alpha
  std::vector<float> alpha;  // as long, or empty: opaque

  Image() = default;
  Image(int width_, int height_)
      : width(width_),
        height(height_),
        pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), Vec3f()) {}

  // For who writes all pixels before any is read.
  static Image unwritten(int width, int height) {
    Image image;
    image.width = width;
    image.height = height;
    image.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return image;
  }

  const Vec3f& at(int x, int y) const { return pixels[index(x, y)]; }
  Vec3f& at(int x, int y) { return pixels[index(x, y)]; }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

}  // namespace dapple
