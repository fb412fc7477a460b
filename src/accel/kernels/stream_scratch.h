// The memory that a thread needs to trace streams: too much for a stack, too often for the heap.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scene/leaf.h"

namespace dapple {

// Rays of a stream at most: their data and what is found of them fits the second-level cache.
inline constexpr std::size_t kStreamRays = 8192;
// Rays that meet a node together at most, and a leaf.
inline constexpr std::size_t kNodePiece = 2048;
inline constexpr std::size_t kLeafPiece = 512;
// Lists end with a vector that need not be full.
inline constexpr std::size_t kListPadding = 16;

// Fewer rays than this are never worth it.
inline constexpr std::size_t kSmallestStream = 256;

// How many rays it takes in a tree for a stream to be worth it, as far as is known: more than have
// failed, but after some time that is tried again.
class StreamPatience {
 public:
  bool try_now(const void* tree, std::size_t rays) {
    if (tree != tree_) *this = StreamPatience(tree);
    if (rays >= enough_) return true;
    enough_ -= enough_ / 128;
    return false;
  }
  void failed(std::size_t rays) { enough_ = rays + rays / 4; }

  StreamPatience() = default;

 private:
  explicit StreamPatience(const void* tree) : tree_(tree) {}

  const void* tree_ = nullptr;
  std::size_t enough_ = kSmallestStream;
};

struct StreamScratch {
  // Of each ray four numbers together, since lists ask for them in any order.
  alignas(64) float origin[4 * kStreamRays];  // and t_min
  alignas(
      64) float inverse[4 * kStreamRays];  // and the distance of the best hit, or what t_max was
  alignas(64) float direction[4 * kStreamRays];  // and inverse_dot
  // The best hit: the bits of its distance above those of its primitive, and its lane's words.
  alignas(64) std::uint64_t best[kStreamRays];
  alignas(64) std::uint32_t lane[kStreamRays];

  // Rays by the signs of their direction, see PlanesBySigns.
  alignas(64) std::uint32_t octants[8][kNodePiece + kListPadding];
  std::uint32_t octant_counts[8];

  // Of the rays that meet the node at hand, vector by vector.
  alignas(64) float node_rays[11 * kNodePiece];
  // Lists of rays that are still to meet something.
  alignas(64) std::uint32_t lists[std::size_t{1} << 16];

  // Rays and spheres of the leaf at hand that may meet, and those that do with their distances.
  alignas(64) std::uint32_t pairs[kLeafPiece * kLeafWidth + kListPadding];
  alignas(64) std::uint32_t found[kLeafPiece * kLeafWidth + kListPadding];
  alignas(64) std::uint32_t found_t[kLeafPiece * kLeafWidth + kListPadding];

  StreamPatience patience;
};

// That of this thread, kept until the thread ends; null if there is no memory for it.
[[nodiscard]] StreamScratch* stream_scratch() noexcept;

}  // namespace dapple
