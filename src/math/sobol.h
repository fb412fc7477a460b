// The first four dimensions of Sobol's low-discrepancy sequence, and the hash-based scrambling that
// makes independent copies of it [Burley20].
#pragma once

#include <array>
#include <cstdint>

namespace dapple {

inline constexpr int kSobolDimensions = 4;

namespace sobol_detail {

// A primitive polynomial over GF(2) with its first direction numbers [JoeKuo08].
struct Polynomial {
  int degree;
  std::uint32_t coefficients;  // without the first and the last
  std::array<std::uint32_t, 3> first;
};
inline constexpr Polynomial kPolynomials[kSobolDimensions - 1] = {
    {1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}};

using Directions = std::array<std::uint32_t, 32>;

constexpr Directions directions(int dimension) {
  Directions v{};
  if (dimension == 0) {
    for (int i = 0; i < 32; ++i) v[i] = 1u << (31 - i);
    return v;
  }
  const Polynomial& p = kPolynomials[dimension - 1];
  for (int i = 0; i < p.degree; ++i) v[i] = p.first[i] << (31 - i);
  for (int i = p.degree; i < 32; ++i) {
    v[i] = v[i - p.degree] ^ v[i - p.degree] >> p.degree;
    for (int k = 1; k < p.degree; ++k) {
      if (p.coefficients >> (p.degree - 1 - k) & 1) v[i] ^= v[i - k];
    }
  }
  return v;
}

constexpr std::uint32_t reversed(std::uint32_t x) {
  std::uint32_t result = 0;
  for (int i = 0; i < 32; ++i) result |= (x >> i & 1) << (31 - i);
  return result;
}

// What each byte of an index contributes, so that a point takes four look-ups; with reversed bits,
// as scrambling wants them.
using ByteTable = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr ByteTable byte_table(int dimension) {
  const Directions v = directions(dimension);
  ByteTable table{};
  for (int byte = 0; byte < 4; ++byte) {
    for (int value = 0; value < 256; ++value) {
      std::uint32_t sum = 0;  // lowest bit first
      for (int bit = 0; bit < 8; ++bit) {
        if (value >> bit & 1) sum ^= v[8 * byte + bit];
      }
      table[byte][value] = reversed(sum);
    }
  }
  return table;
}

inline constexpr std::array<ByteTable, kSobolDimensions> kTables = {byte_table(0), byte_table(1),
                                                                    byte_table(2), byte_table(3)};

}  // namespace sobol_detail

// Point `index` of the sequence in one dimension, in steps of 2^-32, with reversed bits.
constexpr std::uint32_t reversed_sobol(std::uint32_t index, int dimension) {
  const auto& table = sobol_detail::kTables[static_cast<std::size_t>(dimension)];
  return table[0][index & 255] ^ table[1][index >> 8 & 255] ^ table[2][index >> 16 & 255] ^
         table[3][index >> 24];
}

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
  x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
  x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
  return __builtin_bswap32(x);
}

// A permutation in which each bit depends on the lower ones alone [LaineKarras11], constants by
// Vegdahl.
constexpr std::uint32_t permute_upwards(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// Owen's scrambling, of a word given with reversed bits: each bit is flipped or not as the higher
// ones say.
constexpr std::uint32_t owen_scramble_reversed(std::uint32_t reversed, std::uint32_t seed) {
  return reverse_bits(permute_upwards(reversed, seed));
}

// A well mixed word out of two (the finaliser of MurmurHash3 twice).
constexpr std::uint32_t mix(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x85ebca6bu;
  x ^= x >> 13;
  x *= 0xc2b2ae35u;
  return x ^ x >> 16;
}
constexpr std::uint32_t mix(std::uint32_t a, std::uint32_t b) {
  return mix(mix(a) + 0x9e3779b9u * (b + 1));
}

}  // namespace dapple
