#include "accel/partition.h"

#include <algorithm>
#include <vector>

#include "parallel/tasks.h"

namespace dapple {
namespace {

// Room for the right side of a range that one thread splits; kept, as a build splits many.
std::span<BuildPrim> thread_scratch(std::size_t size) {
  thread_local std::vector<BuildPrim> scratch;
  if (scratch.size() < size) scratch.resize(size);
  return scratch;
}

// Stable and without a branch on the side, which nothing could predict: every primitive is written
// to the end of both sides, and the end of one of them moves on.
RangePair partition_serially(std::span<BuildPrim> prims, const PrimRange& range,
                             const SahSplit& split) {
  const std::span<BuildPrim> right = thread_scratch(range.size());
  std::size_t left_end = range.begin, right_count = 0;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const BuildPrim prim = prims[i];
    const bool goes_left = split.goes_left(prim);
    prims[left_end] = prim;
    right[right_count] = prim;
    left_end += goes_left;
    right_count += !goes_left;
  }
  std::copy_n(right.begin(), right_count, prims.begin() + static_cast<std::ptrdiff_t>(left_end));
  return {measure_range(prims, range.begin, left_end), measure_range(prims, left_end, range.end)};
}

// One piece of a large range: how many go left, and where its two sides begin in the result.
struct Piece {
  std::size_t left_count = 0;
  std::size_t left_begin = 0, right_begin = 0;
};

void scatter_piece(std::span<const BuildPrim> from, std::span<BuildPrim> to, const SahSplit& split,
                   const Piece& piece) {
  std::size_t next[2] = {piece.right_begin, piece.left_begin};
  for (const BuildPrim& prim : from) to[next[split.goes_left(prim)]++] = prim;
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
  const std::size_t middle = range.begin + left_total;
  return {measure_range(prims, range.begin, middle), measure_range(prims, middle, range.end)};
}

}  // namespace

RangePair partition_range(std::span<BuildPrim> prims, std::span<BuildPrim> scratch,
                          const PrimRange& range, const SahSplit& split) {
  return range.size() <= kParallelRange ? partition_serially(prims, range, split)
                                        : partition_in_parallel(prims, scratch, range, split);
}

}  // namespace dapple
