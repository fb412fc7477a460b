// Which primitive ids a proof has met, noted by many threads without waiting for each other.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

namespace dapple {

class IdSet {
 public:
  using Bits = std::vector<std::uint64_t>;  // one bit an id

  explicit IdSet(std::size_t id_count) : id_count_(id_count) {}

  // Bits that nobody else writes until they are given back: as many as there are writers at a time.
  [[nodiscard]] Bits take();
  void give_back(Bits bits);

  static void insert(Bits& bits, std::size_t id) { bits[id / 64] |= std::uint64_t{1} << id % 64; }

  // True when every id below the count has been inserted. Not while any bits are taken.
  [[nodiscard]] bool is_full() const;

 private:
  std::size_t id_count_;
  std::mutex mutex_;
  std::vector<Bits> free_;
};

}  // namespace dapple
