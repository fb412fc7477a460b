// random.h for one decision of each lane's path.
#include "math/random.h"
#include "math/simd-inl.h"

#if defined(DAPPLE_MATH_RANDOM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_MATH_RANDOM_INL_H
#undef DAPPLE_MATH_RANDOM_INL_H
#else
#define DAPPLE_MATH_RANDOM_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct RandomCounters {
  WordVec x, y, sample;
  std::uint32_t dimension;
  std::uint64_t seed;
};

struct UniformVec4 {
  FloatVec u0, u1, u2, u3;
};

HWY_INLINE FloatVec uniform_floats(WordVec words) {
  return hn::Mul(to_floats(hn::ShiftRight<8>(words)), all(0x1p-24f));
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE UniformVec4 uniform4(const RandomCounters& of) {
  WordVec c0 = of.x, c1 = of.y, c2 = of.sample, c3 = all_words(of.dimension);
  auto key0 = static_cast<std::uint32_t>(of.seed);
  auto key1 = static_cast<std::uint32_t>(of.seed >> 32);
  for (int round = 0; round < 10; ++round) {
    const WideProduct product0 = multiply_wide(c0, 0xD2511F53u);
    const WideProduct product1 = multiply_wide(c2, 0xCD9E8D57u);
    c0 = hn::Xor(hn::Xor(product1.high, c1), all_words(key0));
    c1 = product1.low;
    c2 = hn::Xor(hn::Xor(product0.high, c3), all_words(key1));
    c3 = product0.low;
    key0 += 0x9E3779B9u;
    key1 += 0xBB67AE85u;
  }
  return {uniform_floats(c0), uniform_floats(c1), uniform_floats(c2), uniform_floats(c3)};
}

#else

// Every other lane of a block of Philox's counters, in the lower halves of 64-bit lanes; what is
// in the upper halves does not count.
using CounterVec = hn::Vec<hn::RepartitionToWide<Words> >;
struct HalfCounters {
  CounterVec c0, c1, c2, c3;
};

// The upper halves as the lower; a shuffle, since on wide vectors shifts wait for the multiplier.
HWY_INLINE CounterVec upper_halves(CounterVec v) {
  return hn::BitCast(hn::RepartitionToWide<Words>(), hn::Shuffle2301(hn::BitCast(Words(), v)));
}

HWY_INLINE void philox_round(std::uint32_t key0, std::uint32_t key1, HalfCounters& c) {
  const hn::RepartitionToWide<Words> d64;
  const auto times = [&](CounterVec v, std::uint32_t factor) HWY_ATTR -> CounterVec {
    return hn::MulEven(hn::BitCast(Words(), v), all_words(factor));
  };
  const CounterVec product0 = times(c.c0, 0xD2511F53u), product1 = times(c.c2, 0xCD9E8D57u);
  c.c0 = hn::Xor3(upper_halves(product1), c.c1, hn::Set(d64, key0));
  c.c1 = product1;
  c.c2 = hn::Xor3(upper_halves(product0), c.c3, hn::Set(d64, key1));
  c.c3 = product0;
}

HWY_INLINE UniformVec4 uniform4(const RandomCounters& of) {
  const hn::RepartitionToWide<Words> d64;
  const auto even = [&](WordVec v) HWY_ATTR -> CounterVec { return hn::BitCast(d64, v); };
  const auto odd = [&](WordVec v) HWY_ATTR -> CounterVec { return upper_halves(even(v)); };
  const CounterVec dimension = hn::Set(d64, of.dimension);
  HalfCounters evens = {even(of.x), even(of.y), even(of.sample), dimension};
  HalfCounters odds = {odd(of.x), odd(of.y), odd(of.sample), dimension};
  auto key0 = static_cast<std::uint32_t>(of.seed);
  auto key1 = static_cast<std::uint32_t>(of.seed >> 32);
  for (int round = 0; round < 10; ++round) {
    philox_round(key0, key1, evens);
    philox_round(key0, key1, odds);
    key0 += 0x9E3779B9u;
    key1 += 0xBB67AE85u;
  }
  const auto uniform = [&](CounterVec e, CounterVec o) HWY_ATTR -> FloatVec {
    return uniform_floats(
        hn::OddEven(hn::BitCast(Words(), upper_halves(o)), hn::BitCast(Words(), e)));
  };
  return {uniform(evens.c0, odds.c0), uniform(evens.c1, odds.c1), uniform(evens.c2, odds.c2),
          uniform(evens.c3, odds.c3)};
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
