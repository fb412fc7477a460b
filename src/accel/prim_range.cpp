#include "accel/prim_range.h"

#include <vector>

#include "parallel/tasks.h"

namespace dapple {
namespace {

PrimRange measure_serially(std::span<const BuildPrim> prims, std::size_t begin, std::size_t end) {
  PrimRange range{begin, end, {}, {}, 0};
  for (std::size_t i = begin; i < end; ++i) range.extend(prims[i]);
  return range;
}

}  // namespace

PrimRange measure_range(std::span<const BuildPrim> prims, std::size_t begin, std::size_t end) {
  const std::size_t size = end - begin;
  if (size <= kParallelRange) return measure_serially(prims, begin, end);
  std::vector<PrimRange> parts((size + kParallelGrain - 1) / kParallelGrain);
  parallel_for_chunks(size, kParallelGrain, [&](std::size_t b, std::size_t e) {
    parts[b / kParallelGrain] = measure_serially(prims, begin + b, begin + e);
  });
  PrimRange range{begin, end, {}, {}, 0};
  for (const PrimRange& part : parts) range.extend_boxes(part);
  return range;
}

}  // namespace dapple
