#include "render/film.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "parallel/parallel.h"
#include "render/kernels/path_kernels.h"

namespace dapple {

void TileSums::add(std::size_t index, const Vec3f& radiance) {
  if (!is_finite(radiance)) {
    ++dropped_;
    return;
  }
  if (std::max({radiance.x, radiance.y, radiance.z}) > kFilmClamp) ++cut_;
  for (int channel = 0; channel < 3; ++channel) {
    const float value = std::clamp(radiance[channel], 0.0f, kFilmClamp);
    // Exact: scaling by a power of two, then rounding to the nearest step.
    sums_[index][static_cast<std::size_t>(channel)] +=
        static_cast<std::int64_t>(static_cast<double>(value * kFilmStepsPerUnit) + 0.5);
  }
}

namespace {

// Means of `count` pixels' sums.
void average(const PixelSum* sums, std::size_t count, int samples, Vec3f* pixels) {
  const double scale = 1.0 / (double{kFilmStepsPerUnit} * samples);
  path_kernels().average(sums->data(), 3 * count, scale, &pixels->x);
}

}  // namespace

Film::Film(int width, int height) : width_(width), height_(height) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  // Huge pages are promised without limit; ordinary memory is refused where there is too little.
  ::operator delete(::operator new(count * sizeof(PixelSum)));
  sums_ = HugeArray<PixelSum>(count);
}

void Film::merge(const TileSums& tile) {
  const std::lock_guard lock(mutex_);
  std::size_t index = 0;
  for (int y = tile.tile().y0; y < tile.tile().y1; ++y) {
    PixelSum* row = sums_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    for (int x = tile.tile().x0; x < tile.tile().x1; ++x, ++index) {
      for (std::size_t c = 0; c < 3; ++c) row[x][c] += tile.sums()[index][c];
    }
  }
  count(tile);
}

Image Film::to_image(int samples) {
  Image image = Image::unwritten(width_, height_);
  const auto columns = static_cast<std::size_t>(width_);
  parallel_for_dynamic(static_cast<std::size_t>(height_), [&](std::size_t row) {
    const std::size_t first = row * columns;
    average(sums_.data() + first, columns, samples, image.pixels.data() + first);
  });
  return image;
}

void FinishedTiles::merge(const TileSums& sums) {
  const Tile& tile = sums.tile();
  const auto columns = static_cast<std::size_t>(tile.width());
  const PixelSum* row = sums.sums().data();
  for (int y = tile.y0; y < tile.y1; ++y, row += columns) {
    average(row, columns, samples_, &image_.at(tile.x0, y));
  }
  count(sums);
}

}  // namespace dapple
