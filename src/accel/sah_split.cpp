#include "accel/sah_split.h"

#include <array>
#include <limits>
#include <vector>

#include "parallel/tasks.h"

namespace dapple {
namespace {

constexpr int kCoarseBins = 16, kFineBins = 32;  // of medium and of high quality

struct Bin {
  Box4 box;
  std::uint32_t count = 0;
};

// Maps twice the centre of a primitive to a bin on each axis.
template <int kBinCount>
struct BinMap {
  Float4 origin, scale;

  explicit BinMap(const Box4& centres) : origin(centres.lo.xyz()) {
    float extent[4], factor[4] = {};
    (centres.hi.xyz() - origin).store(extent);
    for (int axis = 0; axis < 3; ++axis) {
      // A little less than the number of bins, so that the largest centre falls into the last.
      // Zero where the extent is nothing or too small to divide by: all in the first bin.
      const float f = static_cast<float>(kBinCount) * 0.9999f / extent[axis];
      factor[axis] = f < std::numeric_limits<float>::max() ? f : 0.0f;
    }
    scale = Float4::load(factor);
  }
};

template <int kBinCount>
struct Bins {
  std::array<std::array<Bin, kBinCount>, 3> axes;

  void fill(std::span<const BuildPrim> prims, const BinMap<kBinCount>& map) {
    for (const BuildPrim& prim : prims) {
      int index[4];
      ((prim.twice_centre() - map.origin) * map.scale).store_truncated(index);
      const Box4 box{prim.lower(), prim.upper()};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Bin& bin = axes[axis][static_cast<std::size_t>(index[axis])];
        bin.box.extend(box);
        ++bin.count;
      }
    }
  }

  void merge(const Bins& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < kBinCount; ++i) {
        axes[axis][i].box.extend(other.axes[axis][i].box);
        axes[axis][i].count += other.axes[axis][i].count;
      }
    }
  }
};

template <int kBinCount>
Bins<kBinCount> fill_bins(std::span<const BuildPrim> prims, const BinMap<kBinCount>& map) {
  Bins<kBinCount> bins;
  if (prims.size() <= kParallelRange) {
    bins.fill(prims, map);
    return bins;
  }
  std::vector<Bins<kBinCount>> parts((prims.size() + kParallelGrain - 1) / kParallelGrain);
  parallel_for_chunks(prims.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    parts[begin / kParallelGrain].fill(prims.subspan(begin, end - begin), map);
  });
  for (const Bins<kBinCount>& part : parts) bins.merge(part);
  return bins;
}

struct BestSplit {
  float cost = std::numeric_limits<float>::infinity();
  int axis = 0;
  int bin = 0;
};

// Tries every boundary between the bins of one axis.
template <std::size_t kBins>
void sweep_axis(const std::array<Bin, kBins>& bins, int axis, BestSplit& best) {
  constexpr int kBinCount = static_cast<int>(kBins);
  float right_cost[kBins];
  Box4 right;
  std::size_t right_count = 0;
  for (int i = kBinCount - 1; i > 0; --i) {
    right.extend(bins[static_cast<std::size_t>(i)].box);
    right_count += bins[static_cast<std::size_t>(i)].count;
    right_cost[i] = right_count == 0 ? std::numeric_limits<float>::infinity()
                                     : right.half_area() * leaf_cost(right_count);
  }
  Box4 left;
  std::size_t left_count = 0;
  for (int i = 1; i < kBinCount; ++i) {
    left.extend(bins[static_cast<std::size_t>(i - 1)].box);
    left_count += bins[static_cast<std::size_t>(i - 1)].count;
    if (left_count == 0) continue;
    const float cost = left.half_area() * leaf_cost(left_count) + right_cost[i];
    if (cost < best.cost) best = {cost, axis, i};
  }
}

template <std::size_t kBins>
float overlap_of(const std::array<Bin, kBins>& bins, int split) {
  Box4 sides[2];
  for (int i = 0; i < static_cast<int>(kBins); ++i) {
    sides[i < split ? 0 : 1].extend(bins[static_cast<std::size_t>(i)].box);
  }
  const Box4 common{max(sides[0].lo, sides[1].lo), min(sides[0].hi, sides[1].hi)};
  const Bounds3f box = common.bounds();
  return box.lo.x <= box.hi.x && box.lo.y <= box.hi.y && box.lo.z <= box.hi.z ? box.half_area()
                                                                              : 0.0f;
}

template <int kBinCount>
std::optional<SahSplit> find_sah_split(std::span<const BuildPrim> prims, const PrimRange& range) {
  const BinMap<kBinCount> map(range.centre_box);
  const Bins<kBinCount> bins = fill_bins(prims.subspan(range.begin, range.size()), map);
  BestSplit best;
  for (int axis = 0; axis < 3; ++axis) {
    sweep_axis(bins.axes[static_cast<std::size_t>(axis)], axis, best);
  }
  if (best.bin == 0) return std::nullopt;
  float origin[4], scale[4];
  map.origin.store(origin);
  map.scale.store(scale);
  SahSplit split{best.axis, best.bin, origin[best.axis], scale[best.axis], best.cost, 0};
  if (kBinCount == kFineBins) {
    split.overlap = overlap_of(bins.axes[static_cast<std::size_t>(best.axis)], best.bin);
  }
  return split;
}

std::optional<SahSplit> find_middle(const PrimRange& range) {
  const BinMap<2> map(range.centre_box);
  float origin[4], scale[4];
  map.origin.store(origin);
  map.scale.store(scale);
  int axis = 3;
  for (int i = 0; i < 3; ++i) {
    // The smaller the scale, the longer the axis; zero where there is no extent.
    if (scale[i] > 0 && (axis == 3 || scale[i] < scale[axis])) axis = i;
  }
  if (axis == 3) return std::nullopt;
  return SahSplit{axis, 1, origin[axis], scale[axis], 0, 0};
}

}  // namespace

std::optional<SahSplit> find_split(std::span<const BuildPrim> prims, const PrimRange& range,
                                   BvhQuality quality) {
  if (quality == BvhQuality::low) return find_middle(range);
  return quality == BvhQuality::medium ? find_sah_split<kCoarseBins>(prims, range)
                                       : find_sah_split<kFineBins>(prims, range);
}

}  // namespace dapple
