// How the samples of a pixel spread around its centre. Every sample counts the same: instead of
// being weighted, they are placed with the filter's own density [ErnstSS06].
#pragma once

#include <string_view>
#include <vector>

#include "render/kernels/sampling_views.h"
#include "util/error.h"

namespace dapple {

enum class FilterKind {
  box,              // uniform over the pixel
  gaussian,         // standard deviation 0.4 pixels, cut at 1.2
  blackman_harris,  // the four-term window over 3 pixels, as the other renderers have it
};

[[nodiscard]] Expected<FilterKind> parse_filter(std::string_view name);

class PixelFilter {
 public:
  explicit PixelFilter(FilterKind kind);

  // Where in the pixel, along one axis, a uniform number puts a sample: 0.5 is the centre, and
  // what is outside [0, 1) lies in a neighbour.
  float place(float u) const;
  FilterView view() const;

 private:
  std::vector<float> places_;  // the inverse of the distribution at equal steps; empty: uniform
};

}  // namespace dapple
