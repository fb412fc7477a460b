#include "scene_file/id_set.h"

#include <utility>

namespace dapple {

IdSet::Bits IdSet::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!free_.empty()) {
      Bits bits = std::move(free_.back());
      free_.pop_back();
      return bits;
    }
  }
  return Bits((id_count_ + 63) / 64);
}

void IdSet::give_back(Bits bits) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(bits));
}

bool IdSet::is_full() const {
  for (std::size_t word = 0; word < id_count_ / 64; ++word) {
    std::uint64_t all = 0;
    for (const Bits& bits : free_) all |= bits[word];
    if (all != ~std::uint64_t{0}) return false;
  }
  if (id_count_ % 64 == 0) return true;
  std::uint64_t last = 0;
  for (const Bits& bits : free_) last |= bits[id_count_ / 64];
  return last == (std::uint64_t{1} << id_count_ % 64) - 1;
}

}  // namespace dapple
