// How much work goes into a tree.
#pragma once

#include <array>
#include <string_view>

namespace dapple {

enum class BvhQuality {
  low,     // splits in the middle: for previews and animation
  medium,  // binned surface area heuristic
  high,    // finer bins, triangles split, and subtrees moved to where they cost least
};

inline constexpr std::array<std::string_view, 3> kBvhQualityNames = {"low", "medium", "high"};

}  // namespace dapple
