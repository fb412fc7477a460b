// Where samples add up: fixed-point integers, so that the sum does not depend on their order.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "image/image.h"
#include "util/huge_array.h"

namespace dapple {

// One step of the sums is 2^-24 of radiance.
inline constexpr float kFilmStepsPerUnit = 0x1p24f;
// A sample is cut at this value in each channel.
inline constexpr float kFilmClamp = 0x1p14f;
inline constexpr float kLargestFloat = std::numeric_limits<float>::max();

using PixelSum = std::array<std::int64_t, 3>;
static_assert(sizeof(PixelSum) == 3 * sizeof(std::int64_t));

// A rectangle of pixels: columns [x0, x1), rows [y0, y1).
struct Tile {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  int pixel_count() const { return width() * height(); }
};

// Sums of one tile, filled by one thread.
class TileSums {
 public:
  explicit TileSums(const Tile& tile)
      : tile_(tile), sums_(static_cast<std::size_t>(tile.pixel_count())) {}

  // Adds one sample to pixel `index` of the tile (row by row). A sample that is not finite is
  // counted and left out; one that is cut is counted.
  void add(std::size_t index, const Vec3f& radiance);

  // For code that adds many samples at once: the sums, channel by channel, and how many it left
  // out or cut.
  std::int64_t* steps() { return reinterpret_cast<std::int64_t*>(sums_.data()); }
  void drop(std::uint64_t count) { dropped_ += count; }
  void cut(std::uint64_t count) { cut_ += count; }

  const Tile& tile() const { return tile_; }
  std::span<const PixelSum> sums() const { return sums_; }
  std::uint64_t dropped() const { return dropped_; }
  std::uint64_t cut_count() const { return cut_; }

 private:
  Tile tile_;
  std::vector<PixelSum> sums_;
  std::uint64_t dropped_ = 0, cut_ = 0;
};

// Where tiles come together. Merging may be done from any thread, in any order.
class TileTarget {
 public:
  virtual ~TileTarget() = default;

  virtual void merge(const TileSums& tile) = 0;
  // The mean of `samples` samples in each pixel, once: a target of finished tiles has it moved out.
  virtual Image to_image(int samples) = 0;

  // Samples that were not finite and count as black.
  std::uint64_t dropped() const { return dropped_; }
  // Samples brighter than the film holds.
  std::uint64_t cut_count() const { return cut_; }

 protected:
  void count(const TileSums& tile) {
    dropped_ += tile.dropped();
    cut_ += tile.cut_count();
  }

 private:
  std::atomic<std::uint64_t> dropped_ = 0, cut_ = 0;
};

// Sums of the whole picture, to which each pixel's samples may come in any number of tiles.
class Film final : public TileTarget {
 public:
  Film(int width, int height);

  void merge(const TileSums& tile) override;
  Image to_image(int samples) override;

 private:
  int width_;
  int height_;
  HugeArray<PixelSum> sums_;  // zero at first
  std::mutex mutex_;
};

// The picture itself, where a tile brings all samples of its pixels: no sums to clear, to add to
// and to read again.
class FinishedTiles final : public TileTarget {
 public:
  FinishedTiles(int width, int height, int samples)
      : image_(Image::unwritten(width, height)), samples_(samples) {}

  void merge(const TileSums& tile) override;
  Image to_image(int /*samples*/) override { return std::move(image_); }

 private:
  Image image_;
  int samples_;
};

}  // namespace dapple
