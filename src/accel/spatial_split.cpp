#include "accel/spatial_split.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "accel/sah_split.h"

namespace dapple {
namespace {

constexpr int kBins = 8;

struct Bin {
  Box4 box;
  std::size_t begin_count = 0, end_count = 0;  // of primitives that begin and that end in it
};
using Bins = std::array<Bin, kBins>;

// The longest axis, and which bin a coordinate is in.
struct BinMap {
  int axis = 0;
  float origin = 0, scale = 0;  // 0 where the range is a point

  explicit BinMap(const Bounds3f& box) {
    const Vec3f extent = box.hi - box.lo;
    for (int i = 1; i < 3; ++i) {
      if (extent[i] > extent[axis]) axis = i;
    }
    origin = box.lo[axis];
    const float factor = static_cast<float>(kBins) * 0.9999f / extent[axis];
    scale = factor < std::numeric_limits<float>::max() ? factor : 0.0f;
  }
  explicit BinMap(const SpatialSplit& split)
      : axis(split.axis), origin(split.origin), scale(split.scale) {}

  int bin(float x) const {
    return std::clamp(static_cast<int>((x - origin) * scale), 0, kBins - 1);
  }
  float plane(int bin) const { return origin + static_cast<float>(bin) / scale; }
};

// What cannot be split is where its centre is.
struct BinSpan {
  int first, last;
};
BinSpan bins_of(const TriangleClipper& clipper, const BuildPrim& prim, const BinMap& map) {
  const float lo = prim.lo[map.axis], hi = prim.hi[map.axis];
  if (clipper.can_split(prim)) return {map.bin(lo), map.bin(hi)};
  const int bin = map.bin(0.5f * lo + 0.5f * hi);
  return {bin, bin};
}

void add_to_bins(const TriangleClipper& clipper, const BuildPrim& prim, const BinMap& map,
                 Bins& bins) {
  const auto [first, last] = bins_of(clipper, prim, map);
  Bin* const begin = bins.data() + first;
  ++begin->begin_count;
  ++bins[static_cast<std::size_t>(last)].end_count;
  if (first == last) {
    begin->box.extend(prim);
    return;
  }
  const auto count = static_cast<std::size_t>(last - first) + 1;
  std::array<float, kBins + 1> planes;
  std::array<Box4, kBins> parts;
  planes[0] = prim.lo[map.axis];
  for (std::size_t i = 1; i < count; ++i) planes[i] = map.plane(first + static_cast<int>(i));
  planes[count] = prim.hi[map.axis];
  clipper.clip(prim, map.axis, std::span(planes).first(count + 1), parts.data());
  for (std::size_t i = 0; i < count; ++i) begin[i].box.extend(parts[i]);
}

// Tries every boundary between bins.
void sweep(const Bins& bins, std::size_t most, SpatialSplit& best) {
  std::array<Box4, kBins> right_boxes;
  std::array<std::size_t, kBins> right_counts;
  Box4 box;
  std::size_t count = 0;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    box.extend(bins[i].box);
    count += bins[i].end_count;
    right_boxes[i] = box;
    right_counts[i] = count;
  }
  box = {};
  count = 0;
  for (std::size_t i = 1; i < kBins; ++i) {
    box.extend(bins[i - 1].box);
    count += bins[i - 1].begin_count;
    if (count == 0 || right_counts[i] == 0 || count + right_counts[i] > most) continue;
    const float cost = box.half_area() * leaf_cost(count) +
                       right_boxes[i].half_area() * leaf_cost(right_counts[i]);
    if (!(cost < best.cost)) continue;
    best.bin = static_cast<int>(i);
    best.cost = cost;
    best.left = box;
    best.right = right_boxes[i];
    best.left_count = count;
    best.right_count = right_counts[i];
  }
}

float area_with(Box4 box, const BuildPrim& prim) {
  box.extend(prim);
  return box.half_area();
}

// Whole on one side if that costs less than a part on each.
enum class Goes { left, right, both };
Goes cheapest_side(const BuildPrim& prim, const SpatialSplit& split) {
  const float left = split.left.half_area(), right = split.right.half_area();
  const auto left_count = static_cast<float>(split.left_count);
  const auto right_count = static_cast<float>(split.right_count);
  const float both = left * left_count + right * right_count;
  const float to_left = area_with(split.left, prim) * left_count + right * (right_count - 1);
  const float to_right = left * (left_count - 1) + area_with(split.right, prim) * right_count;
  if (both <= to_left && both <= to_right) return Goes::both;
  return to_left <= to_right ? Goes::left : Goes::right;
}

bool is_empty(const Box4& box) {
  const Bounds3f b = box.bounds();
  return !(b.lo.x <= b.hi.x && b.lo.y <= b.hi.y && b.lo.z <= b.hi.z);
}

BuildPrim part_of(const BuildPrim& prim, const Box4& box) {
  BuildPrim part;
  box.lo.store(part.lo);  // and, with the fourth lanes, over what follows
  box.hi.store(part.hi);
  part.id = prim.id;
  part.is_part = 1;
  return part;
}

// Which way a primitive goes, with its parts if it goes both ways.
Goes side_of(const TriangleClipper& clipper, const BuildPrim& prim, const SpatialSplit& split,
             std::array<Box4, 2>& parts) {
  const auto [first, last] = bins_of(clipper, prim, BinMap(split));
  if (last < split.bin) return Goes::left;
  if (first >= split.bin) return Goes::right;
  const Goes side = cheapest_side(prim, split);
  if (side != Goes::both) return side;
  const std::array<float, 3> planes = {prim.lo[split.axis], split.plane(), prim.hi[split.axis]};
  clipper.clip(prim, split.axis, planes, parts.data());
  if (is_empty(parts[0])) return Goes::right;
  return is_empty(parts[1]) ? Goes::left : Goes::both;
}

}  // namespace

std::optional<SpatialSplit> find_spatial_split(const TriangleClipper& clipper,
                                               std::span<const BuildPrim> prims,
                                               const PrimRange& range) {
  const BinMap map(range.box.bounds());
  if (map.scale == 0) return std::nullopt;
  Bins bins;
  for (const BuildPrim& prim : prims.subspan(range.begin, range.size())) {
    add_to_bins(clipper, prim, map, bins);
  }
  SpatialSplit best;
  best.axis = map.axis;
  best.origin = map.origin;
  best.scale = map.scale;
  best.cost = std::numeric_limits<float>::infinity();
  sweep(bins, range.size() + range.room, best);
  if (best.bin == 0) return std::nullopt;
  return best;
}

RangePair partition_spatially(const TriangleClipper& clipper, std::span<BuildPrim> prims,
                              const PrimRange& range, const SpatialSplit& split) {
  thread_local std::vector<BuildPrim> right;
  right.clear();
  std::size_t end = range.begin;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const BuildPrim prim = prims[i];
    std::array<Box4, 2> parts;
    const Goes side = side_of(clipper, prim, split, parts);
    if (side != Goes::right) prims[end++] = side == Goes::both ? part_of(prim, parts[0]) : prim;
    if (side != Goes::left) right.push_back(side == Goes::both ? part_of(prim, parts[1]) : prim);
  }
  std::copy(right.begin(), right.end(), prims.begin() + static_cast<std::ptrdiff_t>(end));
  const std::size_t right_end = end + right.size();
  const RangePair sides = {measure_range(prims, range.begin, end),
                           measure_range(prims, end, right_end)};
  return share_room(prims, sides, range.end + range.room - right_end);
}

RangePair share_room(std::span<BuildPrim> prims, RangePair sides, std::size_t room) {
  auto& [left, right] = sides;
  left.room = room * left.size() / (left.size() + right.size());
  right.room = room - left.room;
  if (left.room == 0) return sides;
  const auto begin = prims.begin() + static_cast<std::ptrdiff_t>(right.begin);
  const auto end = prims.begin() + static_cast<std::ptrdiff_t>(right.end);
  std::move_backward(begin, end, end + static_cast<std::ptrdiff_t>(left.room));
  right.begin += left.room;
  right.end += left.room;
  return sides;
}

}  // namespace dapple
