// Sampling of the unit square by a density that is constant in each cell of a grid, by inverting
// its cumulative distributions. A table of guides [ChenA74] says near which cell to look, which
// takes two or three memory accesses where a binary search takes ten.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec2.h"
#include "util/huge_array.h"

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

  // The tables as vector code reads them, see below.
  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  const float* cdfs() const { return cdfs_.data(); }
  const std::uint32_t* guides() const { return guides_.data(); }

 private:
  std::span<const float> cdf_of_row(std::size_t y) const;
  std::span<const std::uint32_t> guides_of_row(std::size_t y) const;

  std::size_t columns_ = 0, rows_ = 0;
  // One distribution after the other: that of the rows, rows_ + 1 values from 0 to 1, then of each
  // row's cells, columns_ + 1 values. Element i of a distribution's guides is the last cell that
  // begins at or before i over their number.
  HugeArray<float> cdfs_;
  HugeArray<std::uint32_t> guides_;
};

}  // namespace dapple
