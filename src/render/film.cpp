#include "render/film.h"

#include <algorithm>
#include <cmath>
#include <new>

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
  dropped_ += tile.dropped();
  cut_ += tile.cut_count();
}

Image Film::to_image(int samples) const {
  Image image(width_, height_);
  const double scale = 1.0 / (double{kFilmStepsPerUnit} * samples);
  const auto mean = [&](std::int64_t sum) {
    return static_cast<float>(static_cast<double>(sum) * scale);
  };
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    image.pixels[i] = {mean(sums_[i][0]), mean(sums_[i][1]), mean(sums_[i][2])};
  }
  return image;
}

}  // namespace dapple
