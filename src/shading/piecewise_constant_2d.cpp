#include "shading/piecewise_constant_2d.h"

#include <algorithm>
#include <span>

namespace dapple {
namespace {

constexpr float kBelowOne = 0x1.fffffep-1f;

// Sums of weights, scaled to end at 1; uniform if all are zero. Returns the sum.
double accumulate(std::span<const float> weights, std::span<float> cdf) {
  double total = 0;
  for (const float w : weights) total += w;
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    cdf[i] = static_cast<float>(total > 0 ? sum / total
                                          : static_cast<double>(i) / double(weights.size()));
    sum += weights[i];
  }
  cdf[weights.size()] = 1;
  return total;
}

struct Found {
  std::size_t cell;
  float within;  // in [0, 1)
  float mass;
};

// The last cell that begins at or before u, by a search without branches.
Found find(std::span<const float> cdf, float u) {
  std::size_t cell = 0;
  for (std::size_t left = cdf.size() - 1; left > 1;) {
    const std::size_t half = left / 2;
    cell += cdf[cell + half] <= u ? half : 0;
    left -= half;
  }
  const float mass = cdf[cell + 1] - cdf[cell];
  const float within = mass > 0 ? (u - cdf[cell]) / mass : 0.5f;
  return {cell, std::min(within, kBelowOne), mass};
}

std::size_t cell_of(float x, std::size_t count) {
  const auto i = static_cast<std::size_t>(x > 0 ? x * static_cast<float>(count) : 0.0f);
  return std::min(i, count - 1);
}

}  // namespace

PiecewiseConstant2d::PiecewiseConstant2d(std::vector<float> weights, std::size_t columns,
                                         std::size_t rows)
    : columns_(columns), rows_(rows), row_cdf_(rows + 1), cell_cdf_(rows * (columns + 1)) {
  std::vector<float> row_sums(rows);
  const std::span<float> cdfs(cell_cdf_);
  for (std::size_t y = 0; y < rows; ++y) {
    row_sums[y] = static_cast<float>(accumulate(std::span(weights).subspan(y * columns, columns),
                                                cdfs.subspan(y * (columns + 1), columns + 1)));
  }
  accumulate(row_sums, row_cdf_);
}

PiecewiseConstant2d::Sample PiecewiseConstant2d::sample(Vec2f u) const {
  const Found row = find(row_cdf_, u.y);
  const Found cell =
      find(std::span(cell_cdf_).subspan(row.cell * (columns_ + 1), columns_ + 1), u.x);
  const auto columns = static_cast<float>(columns_), rows = static_cast<float>(rows_);
  return {{(static_cast<float>(cell.cell) + cell.within) / columns,
           (static_cast<float>(row.cell) + row.within) / rows},
          row.mass * cell.mass * columns * rows};
}

float PiecewiseConstant2d::pdf(Vec2f point) const {
  const std::size_t x = cell_of(point.x, columns_), y = cell_of(point.y, rows_);
  const float* cdf = cell_cdf_.data() + y * (columns_ + 1);
  return (row_cdf_[y + 1] - row_cdf_[y]) * (cdf[x + 1] - cdf[x]) *
         static_cast<float>(columns_ * rows_);
}

}  // namespace dapple
