// Counter-based random numbers: a value is a function of what it is for, never of the order in
// which values were asked for, so a picture has the same bits on any number of threads.
//
// Philox4x32-10 of Salmon et al. [SalmonMDS11]: four 32-bit words from a 128-bit counter and a
// 64-bit key, ten rounds of two 32x32-bit multiplications.
#pragma once

#include <array>
#include <cstdint>

namespace dapple {

using PhiloxBlock = std::array<std::uint32_t, 4>;

constexpr PhiloxBlock philox4x32(PhiloxBlock counter, std::uint64_t key) {
  auto key0 = static_cast<std::uint32_t>(key);
  auto key1 = static_cast<std::uint32_t>(key >> 32);
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = std::uint64_t{0xD2511F53u} * counter[0];
    const std::uint64_t product1 = std::uint64_t{0xCD9E8D57u} * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key0,
               static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key1,
               static_cast<std::uint32_t>(product0)};
    key0 += 0x9E3779B9u;
    key1 += 0xBB67AE85u;
  }
  return counter;
}

// A uniform float in [0, 1), a multiple of 2^-24.
constexpr float uniform_float(std::uint32_t word) {
  return static_cast<float>(word >> 8) * 0x1p-24f;
}

// The four uniform numbers that one decision of one sample of one pixel may use.
constexpr std::array<float, 4> uniform4(std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                                        std::uint32_t dimension, std::uint64_t seed) {
  const PhiloxBlock words = philox4x32({x, y, sample, dimension}, seed);
  return {uniform_float(words[0]), uniform_float(words[1]), uniform_float(words[2]),
          uniform_float(words[3])};
}

}  // namespace dapple
