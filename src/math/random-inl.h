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

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
