// sobol.h for one index a lane.
#include "math/random-inl.h"
#include "math/sobol.h"

#if defined(DAPPLE_MATH_SOBOL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_MATH_SOBOL_INL_H
#undef DAPPLE_MATH_SOBOL_INL_H
#else
#define DAPPLE_MATH_SOBOL_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

template <int kBits>
HWY_INLINE WordVec exchange(WordVec x, std::uint32_t lower) {
  const WordVec mask = all_words(lower);
  return hn::Or(hn::ShiftLeft<kBits>(hn::And(x, mask)), hn::And(hn::ShiftRight<kBits>(x), mask));
}

HWY_INLINE WordVec reverse_bits(WordVec x) {
  x = exchange<1>(x, 0x55555555u);
  x = exchange<2>(x, 0x33333333u);
  x = exchange<4>(x, 0x0f0f0f0fu);
  x = exchange<8>(x, 0x00ff00ffu);
  return hn::Or(hn::ShiftLeft<16>(x), hn::ShiftRight<16>(x));
}

HWY_INLINE WordVec times(WordVec x, std::uint32_t factor) { return hn::Mul(x, all_words(factor)); }

HWY_INLINE WordVec owen_scramble_reversed(WordVec x, WordVec seed) {
  x = hn::Xor(x, times(x, 0x3d20adeau));
  x = hn::Add(x, seed);
  x = hn::Mul(x, hn::Or(hn::ShiftRight<16>(seed), all_words(1)));
  x = hn::Xor(x, times(x, 0x05526c56u));
  x = hn::Xor(x, times(x, 0x53a22864u));
  return reverse_bits(x);
}

HWY_INLINE WordVec mix(WordVec x) {
  x = times(hn::Xor(x, hn::ShiftRight<16>(x)), 0x85ebca6bu);
  x = times(hn::Xor(x, hn::ShiftRight<13>(x)), 0xc2b2ae35u);
  return hn::Xor(x, hn::ShiftRight<16>(x));
}
HWY_INLINE WordVec mix(WordVec a, WordVec b) {
  return mix(hn::Add(mix(a), times(hn::Add(b, all_words(1)), 0x9e3779b9u)));
}

// The first dimension only reverses the index. The second is Pascal's triangle modulo 2, which is
// its own halves at every scale.
HWY_INLINE WordVec reversed_sobol_1(WordVec x) {
  x = hn::Xor(x, hn::And(hn::ShiftRight<1>(x), all_words(0x55555555u)));
  x = hn::Xor(x, hn::And(hn::ShiftRight<2>(x), all_words(0x33333333u)));
  x = hn::Xor(x, hn::And(hn::ShiftRight<4>(x), all_words(0x0f0f0f0fu)));
  x = hn::Xor(x, hn::And(hn::ShiftRight<8>(x), all_words(0x00ff00ffu)));
  return hn::Xor(x, hn::ShiftRight<16>(x));
}

HWY_INLINE WordVec reversed_sobol_by_table(WordVec index, const sobol_detail::ByteTable& table,
                                           int bits) {
  const std::uint32_t* words = &table[0][0];
  const WordVec byte = all_words(255);
  WordVec result = gather(words, hn::And(index, byte));
  if (bits > 8) {
    const WordVec next = hn::And(hn::ShiftRight<8>(index), byte);
    result = hn::Xor(result, gather(words + 256, next));
  }
  if (bits > 16) {
    const WordVec next = hn::And(hn::ShiftRight<16>(index), byte);
    result = hn::Xor(result, gather(words + 512, next));
  }
  if (bits > 24) result = hn::Xor(result, gather(words + 768, hn::ShiftRight<24>(index)));
  return result;
}

// PathSampler::uniform4, `bits` of whose positions are in use.
HWY_INLINE UniformVec4 owen_sobol4(WordVec block, WordVec reversed_position, WordVec dimension,
                                   int bits) {
  const WordVec sequence = mix(block, dimension);
  const WordVec index =
      hn::ShiftRightSame(owen_scramble_reversed(reversed_position, sequence), 32 - bits);
  const auto scrambled = [&](WordVec point, std::uint32_t i) HWY_ATTR {
    return uniform_floats(owen_scramble_reversed(point, mix(sequence, all_words(i + 1))));
  };
  return {scrambled(index, 0), scrambled(reversed_sobol_1(index), 1),
          scrambled(reversed_sobol_by_table(index, sobol_detail::kTables[2], bits), 2),
          scrambled(reversed_sobol_by_table(index, sobol_detail::kTables[3], bits), 3)};
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
