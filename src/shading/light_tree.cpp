#include "shading/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "math/fast_functions.h"

namespace dapple {
namespace {

constexpr int kBins = 12;
constexpr float kBelowOne = 0x1.fffffep-1f;

Vec3f centre(const LightBounds& l) { return 0.5f * (l.bounds.lo + l.bounds.hi); }

// Power times surface times the solid angle of directions that are shone into.
float cost_of(const LightBounds& l) {
  if (!(l.power > 0.0f)) return 0;
  const Vec3f d = l.bounds.hi - l.bounds.lo;
  const float directions = 2.0f - std::max(l.cos_spread, 0.0f);
  return l.power * directions * (l.bounds.half_area() + 1e-6f * dot(d, d) + 1e-20f);
}

struct Split {
  float cost = std::numeric_limits<float>::infinity();
  int axis = -1;
  int bin = 0;  // the first of the second side
};

// Which bin of an axis a light's centre lies in.
class Binning {
 public:
  Binning(const Bounds3f& centres, int axis)
      : axis_(axis), lo_(centres.lo[axis]), scale_(kBins / (centres.hi[axis] - lo_)) {}
  int operator()(const LightBounds& light) const {
    return std::clamp(static_cast<int>((centre(light)[axis_] - lo_) * scale_), 0, kBins - 1);
  }

 private:
  int axis_;
  float lo_, scale_;
};

Split best_of_axis(std::span<const LightBounds> lights, std::span<const std::uint32_t> ids,
                   const Bounds3f& centres, int axis) {
  Split best;
  if (!(centres.hi[axis] > centres.lo[axis])) return best;
  const Binning bin_of(centres, axis);
  std::array<LightBounds, kBins> bins;
  for (const std::uint32_t id : ids) {
    LightBounds& bin = bins[static_cast<std::size_t>(bin_of(lights[id]))];
    bin = merged(bin, lights[id]);
  }
  std::array<float, kBins> above{};
  LightBounds sum;
  for (int i = kBins - 1; i > 0; --i) {
    sum = merged(sum, bins[static_cast<std::size_t>(i)]);
    above[static_cast<std::size_t>(i)] = cost_of(sum);
  }
  sum = {};
  for (int i = 1; i < kBins; ++i) {
    sum = merged(sum, bins[static_cast<std::size_t>(i - 1)]);
    const float cost = cost_of(sum) + above[static_cast<std::size_t>(i)];
    if (cost < best.cost) best = {cost, axis, i};
  }
  // Slices of a long box are no better for being thin.
  const Vec3f extent = centres.hi - centres.lo;
  best.cost *= max_abs_component(extent) / extent[axis];
  return best;
}

// How many of the ids come first after they are parted in two, never none or all.
std::size_t part(std::span<const LightBounds> lights, std::span<std::uint32_t> ids) {
  Bounds3f centres;
  for (const std::uint32_t id : ids) centres.extend({centre(lights[id]), centre(lights[id])});
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    const Split split = best_of_axis(lights, ids, centres, axis);
    if (split.cost < best.cost) best = split;
  }
  if (best.axis >= 0) {
    const Binning bin_of(centres, best.axis);
    const auto middle = std::stable_partition(
        ids.begin(), ids.end(), [&](std::uint32_t id) { return bin_of(lights[id]) < best.bin; });
    const auto first = static_cast<std::size_t>(middle - ids.begin());
    if (first > 0 && first < ids.size()) return first;
  }
  return ids.size() / 2;
}

}  // namespace

LightTree::LightTree(std::span<const LightBounds> lights) : leaf_of_(lights.size(), kNone) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (lights[i].power > 0.0f) ids.push_back(i);
  }
  if (ids.empty()) return;
  nodes_.reserve(2 * ids.size() - 1);
  build(lights, ids, kNone);
}

// Bins by power may be uneven; the recursion is as deep as the tree, which median splits where
// binning fails keep shallow.
std::uint32_t LightTree::build(std::span<const LightBounds> lights, std::span<std::uint32_t> ids,
                               std::uint32_t parent) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back().parent = parent;
  if (ids.size() == 1) {
    nodes_[index].bounds = lights[ids[0]];
    nodes_[index].light = ids[0];
    leaf_of_[ids[0]] = index;
    return index;
  }
  const std::size_t first = part(lights, ids);
  build(lights, ids.first(first), index);
  const std::uint32_t second = build(lights, ids.subspan(first), index);
  nodes_[index].second_child = second;
  nodes_[index].bounds = merged(nodes_[index + 1].bounds, nodes_[second].bounds);
  return index;
}

std::optional<float> LightTree::first_probability(const Node& node, std::uint32_t index,
                                                  const Vec3f& position,
                                                  const Vec3f& normal) const {
  const float first = importance(nodes_[index + 1].bounds, position, normal);
  const float second = importance(nodes_[node.second_child].bounds, position, normal);
  if (!(first + second > 0.0f)) return std::nullopt;
  return first / (first + second);
}

std::optional<LightTree::Choice> LightTree::choose(const Vec3f& position, const Vec3f& normal,
                                                   float u) const {
  if (nodes_.empty()) return std::nullopt;
  float probability = 1;
  std::uint32_t index = 0;
  while (nodes_[index].light == kNone) {
    const Node& node = nodes_[index];
    const auto first = first_probability(node, index, position, normal);
    if (!first) return std::nullopt;
    if (u < *first) {
      u = std::min(u / *first, kBelowOne);
      probability *= *first;
      ++index;
    } else {
      u = std::min((u - *first) / (1.0f - *first), kBelowOne);
      probability *= 1.0f - *first;
      index = node.second_child;
    }
  }
  return Choice{nodes_[index].light, probability};
}

float LightTree::probability(const Vec3f& position, const Vec3f& normal,
                             std::uint32_t light) const {
  std::uint32_t index = leaf_of_[light];
  if (index == kNone) return 0;
  float probability = 1;
  while (nodes_[index].parent != kNone) {
    const std::uint32_t parent = nodes_[index].parent;
    const auto first = first_probability(nodes_[parent], parent, position, normal);
    if (!first) return 0;
    probability *= index == parent + 1 ? *first : 1.0f - *first;
    index = parent;
  }
  return probability;
}

float LightTree::total_importance(const Vec3f& position, const Vec3f& normal) const {
  return nodes_.empty() ? 0.0f : importance(nodes_[0].bounds, position, normal);
}

}  // namespace dapple
