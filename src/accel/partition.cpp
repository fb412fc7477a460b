#include "accel/partition.h"

#include <algorithm>
#include <vector>

#include "parallel/tasks.h"

namespace dapple {
namespace {

// From both ends towards the middle, exchanging what stands on the wrong side.
RangePair partition_in_place(std::span<BuildPrim> prims, const PrimRange& range,
                             const SahSplit& split) {
  PrimRange left{range.begin, range.begin, {}, {}};
  PrimRange right{range.end, range.end, {}, {}};
  while (true) {
    while (left.end < right.begin && split.goes_left(prims[left.end])) {
      left.extend(prims[left.end++]);
    }
    while (left.end < right.begin && !split.goes_left(prims[right.begin - 1])) {
      right.extend(prims[--right.begin]);
    }
    if (left.end == right.begin) return {left, right};
    std::swap(prims[left.end], prims[right.begin - 1]);
  }
}

// One piece of a large range: how many go left, and where its two sides begin in the result.
struct Piece {
  std::size_t left_count = 0;
  std::size_t left_begin = 0, right_begin = 0;
  PrimRange left, right;
};

void scatter_piece(std::span<const BuildPrim> from, std::span<BuildPrim> to, const SahSplit& split,
                   Piece& piece) {
  std::size_t next_left = piece.left_begin, next_right = piece.right_begin;
  for (const BuildPrim& prim : from) {
    const bool goes_left = split.goes_left(prim);
    (goes_left ? piece.left : piece.right).extend(prim);
    to[goes_left ? next_left++ : next_right++] = prim;
  }
}

// Stable, through the scratch array: count, place, copy back, each in pieces of fixed size.
RangePair partition_in_parallel(std::span<BuildPrim> prims, std::span<BuildPrim> scratch,
                                const PrimRange& range, const SahSplit& split) {
  const auto source = prims.subspan(range.begin, range.size());
  const auto target = scratch.subspan(range.begin, range.size());
  std::vector<Piece> pieces((source.size() + kParallelGrain - 1) / kParallelGrain);
  parallel_for_chunks(source.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    const auto part = source.subspan(begin, end - begin);
    pieces[begin / kParallelGrain].left_count = static_cast<std::size_t>(std::count_if(
        part.begin(), part.end(), [&](const BuildPrim& prim) { return split.goes_left(prim); }));
  });
  std::size_t left_total = 0;
  for (Piece& piece : pieces) {
    piece.left_begin = left_total;
    left_total += piece.left_count;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].right_begin = left_total + i * kParallelGrain - pieces[i].left_begin;
  }
  parallel_for_chunks(source.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    scatter_piece(source.subspan(begin, end - begin), target, split,
                  pieces[begin / kParallelGrain]);
  });
  parallel_for_chunks(source.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    std::copy(target.begin() + static_cast<std::ptrdiff_t>(begin),
              target.begin() + static_cast<std::ptrdiff_t>(end),
              source.begin() + static_cast<std::ptrdiff_t>(begin));
  });
  PrimRange left{range.begin, range.begin + left_total, {}, {}};
  PrimRange right{range.begin + left_total, range.end, {}, {}};
  for (const Piece& piece : pieces) {
    left.extend_boxes(piece.left);
    right.extend_boxes(piece.right);
  }
  return {left, right};
}

}  // namespace

RangePair partition_range(std::span<BuildPrim> prims, std::span<BuildPrim> scratch,
                          const PrimRange& range, const SahSplit& split) {
  return range.size() <= kParallelRange ? partition_in_place(prims, range, split)
                                        : partition_in_parallel(prims, scratch, range, split);
}

}  // namespace dapple
