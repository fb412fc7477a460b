#include "render/path_batch.h"

namespace dapple {
namespace {

constexpr std::size_t kBytesPerPath =
    sizeof(Ray) + sizeof(Hit) + 3 * sizeof(float) + sizeof(std::uint32_t);

// The next array of `count` elements in the memory.
template <class T>
T* carve(std::uint8_t*& next, std::size_t count) {
  T* array = reinterpret_cast<T*>(next);
  next += count * sizeof(T);
  return array;
}

}  // namespace

void PathBatch::reserve(std::size_t capacity) {
  if (capacity <= capacity_) return;
  const std::size_t count = (capacity + kPathPadding + 15) / 16 * 16;  // whole cache lines
  memory_ = HugeArray<std::uint8_t>(count * kBytesPerPath);
  capacity_ = capacity;
  std::uint8_t* next = memory_.data();
  arrays_.rays = carve<Ray>(next, count);
  arrays_.hits = carve<Hit>(next, count);
  for (float*& channel : arrays_.throughput) channel = carve<float>(next, count);
  arrays_.place = carve<std::uint32_t>(next, count);
}

}  // namespace dapple
