// Sampling of the unit square by a density that is constant in each cell of a grid.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec2.h"

namespace dapple {

class PiecewiseConstant2d {
 public:
  PiecewiseConstant2d() = default;
  // Weights of the cells, not negative, row by row. If none is positive, all count as one.
  PiecewiseConstant2d(std::vector<float> weights, std::size_t columns, std::size_t rows);

  struct Sample {
    Vec2f point;
    float pdf = 0;
  };
  Sample sample(Vec2f u) const;
  float pdf(Vec2f point) const;

 private:
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<float> row_cdf_;   // rows_ + 1 values from 0 to 1
  std::vector<float> cell_cdf_;  // columns_ + 1 values a row
};

}  // namespace dapple
