// Sets of rays cut into pieces that threads take one after the other.
#pragma once

#include <algorithm>
#include <cstddef>

#include "kernels/tracer.h"
#include "parallel/parallel.h"

namespace dapple::bench {

// Calls body(begin, end) for the pieces of [0, count).
template <class Body>
void for_each_piece(std::size_t count, const Body& body) {
  parallel_for_dynamic((count + kRaysPerPiece - 1) / kRaysPerPiece, [&](std::size_t piece) {
    const std::size_t begin = piece * kRaysPerPiece;
    body(begin, std::min(begin + kRaysPerPiece, count));
  });
}

}  // namespace dapple::bench
