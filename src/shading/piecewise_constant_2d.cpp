#include "shading/piecewise_constant_2d.h"

#include <algorithm>
#include <span>

#include "parallel/parallel.h"

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

void set_guides(std::span<const float> cdf, std::span<std::uint32_t> guides) {
  std::uint32_t cell = 0;
  for (std::size_t i = 0; i < guides.size(); ++i) {
    const float u = static_cast<float>(i) / static_cast<float>(guides.size());
    while (cell + 2 < cdf.size() && cdf[cell + 1] <= u) ++cell;
    guides[i] = cell;
  }
}

struct Found {
  std::size_t cell;
  float within;  // in [0, 1)
  float mass;
};

// The last cell that begins at or before u.
Found find(std::span<const float> cdf, std::span<const std::uint32_t> guides, float u) {
  const auto bucket = static_cast<std::size_t>(u * static_cast<float>(guides.size()));
  std::size_t cell = guides[std::min(bucket, guides.size() - 1)];
  while (cell > 0 && cdf[cell] > u) --cell;  // where rounding put u into the next bucket
  while (cell + 2 < cdf.size() && cdf[cell + 1] <= u) ++cell;
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
    : columns_(columns),
      rows_(rows),
      cdfs_(rows + 1 + rows * (columns + 1)),
      guides_(rows + rows * columns) {
  std::vector<float> row_sums(rows);
  const std::span<float> cdfs(cdfs_.data(), cdfs_.size());
  const std::span<std::uint32_t> guides(guides_.data(), guides_.size());
  parallel_for_dynamic(rows, [&](std::size_t y) {
    const auto cdf = cdfs.subspan(rows + 1 + y * (columns + 1), columns + 1);
    row_sums[y] =
        static_cast<float>(accumulate(std::span(weights).subspan(y * columns, columns), cdf));
    set_guides(cdf, guides.subspan(rows + y * columns, columns));
  });
  accumulate(row_sums, cdfs.first(rows + 1));
  set_guides(cdfs.first(rows + 1), guides.first(rows));
}

std::span<const float> PiecewiseConstant2d::cdf_of_row(std::size_t y) const {
  return {cdfs_.data() + rows_ + 1 + y * (columns_ + 1), columns_ + 1};
}

std::span<const std::uint32_t> PiecewiseConstant2d::guides_of_row(std::size_t y) const {
  return {guides_.data() + rows_ + y * columns_, columns_};
}

PiecewiseConstant2d::Sample PiecewiseConstant2d::sample(Vec2f u) const {
  const Found row = find({cdfs_.data(), rows_ + 1}, {guides_.data(), rows_}, u.y);
  const Found cell = find(cdf_of_row(row.cell), guides_of_row(row.cell), u.x);
  const auto columns = static_cast<float>(columns_), rows = static_cast<float>(rows_);
  return {{(static_cast<float>(cell.cell) + cell.within) / columns,
           (static_cast<float>(row.cell) + row.within) / rows},
          row.mass * cell.mass * columns * rows};
}

float PiecewiseConstant2d::pdf(Vec2f point) const {
  const std::size_t x = cell_of(point.x, columns_), y = cell_of(point.y, rows_);
  const std::span<const float> cdf = cdf_of_row(y);
  return (cdfs_.data()[y + 1] - cdfs_.data()[y]) * (cdf[x + 1] - cdf[x]) *
         static_cast<float>(columns_ * rows_);
}

}  // namespace dapple
