// The scenes whose pictures are held against the reference.
#pragma once

#include <cstddef>

namespace dapple::test {

inline constexpr std::size_t kPictureCaseCount = 11;

// Compares picture `index`, with `factor` times the samples of the short test; records failures.
void check_picture(std::size_t index, int factor);

}  // namespace dapple::test
