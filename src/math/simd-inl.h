// Vectors of up to 16 floats, one path, ray or primitive a lane, for the instruction set being
// compiled. Nothing of std:: may be called in files named -inl.h: its templates would be compiled
// once for each instruction set under one name, and the linker keeps any of them for everyone.
//
// Only operations that round as IEEE 754 says are used (+ - * / and square root), in the order of
// the scalar definitions, so that every instruction set gives the scalar bits.
#include <hwy/highway.h>

#include "math/vec3.h"

#if defined(DAPPLE_MATH_SIMD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_MATH_SIMD_INL_H
#undef DAPPLE_MATH_SIMD_INL_H
#else
#define DAPPLE_MATH_SIMD_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using FloatVec = hn::Vec<Floats>;
using FloatMask = hn::Mask<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using WordVec = hn::Vec<Words>;
using WordMask = hn::Mask<Words>;
using Ints = hn::RebindToSigned<Floats>;
inline constexpr std::size_t kLanes = hn::MaxLanes(Floats());

HWY_INLINE FloatVec all(float x) { return hn::Set(Floats(), x); }
HWY_INLINE WordVec all_words(std::uint32_t x) { return hn::Set(Words(), x); }
// first, first + 1 and so on. Iota itself would go through memory, where `first` is not a constant.
HWY_INLINE WordVec words_from(std::uint32_t first) {
  return hn::Add(hn::Iota(Words(), 0), all_words(first));
}
HWY_INLINE FloatVec load_floats(const float* floats) { return hn::Load(Floats(), floats); }

// As x86 has them and as `a < b ? a : b` says: the second where one is not a number.
HWY_INLINE FloatVec smaller(FloatVec a, FloatVec b) { return hn::IfThenElse(hn::Lt(a, b), a, b); }
HWY_INLINE FloatVec larger(FloatVec a, FloatVec b) { return hn::IfThenElse(hn::Gt(a, b), a, b); }

struct FloatVec3 {
  FloatVec x, y, z;
};

HWY_INLINE FloatVec3 all(const Vec3f& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE FloatVec3 operator-(FloatVec3 a) { return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)}; }
HWY_INLINE FloatVec3 operator+(FloatVec3 a, FloatVec3 b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE FloatVec3 operator-(FloatVec3 a, FloatVec3 b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE FloatVec3 operator*(FloatVec3 a, FloatVec3 b) {
  return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
HWY_INLINE FloatVec3 operator*(FloatVec s, FloatVec3 a) {
  return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
HWY_INLINE FloatVec3 operator/(FloatVec3 a, FloatVec s) { return hn::Div(all(1.0f), s) * a; }
HWY_INLINE FloatVec dot(FloatVec3 a, FloatVec3 b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE FloatVec length(FloatVec3 a) { return hn::Sqrt(dot(a, a)); }
HWY_INLINE FloatVec3 normalize(FloatVec3 a) { return a / length(a); }
HWY_INLINE FloatVec max_abs_component(FloatVec3 a) {
  return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}
HWY_INLINE FloatVec3 select(FloatMask mask, FloatVec3 yes, FloatVec3 no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}

HWY_INLINE bool any(FloatMask mask) { return !hn::AllFalse(Floats(), mask); }
// Bit i is lane i of the mask.
HWY_INLINE std::uint32_t bits_of(FloatMask mask) {
#if HWY_TARGET <= HWY_AVX3
  return static_cast<std::uint32_t>(mask.raw);
#elif HWY_TARGET == HWY_AVX2
  return static_cast<std::uint32_t>(_mm256_movemask_ps(mask.raw));
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  return static_cast<std::uint32_t>(_mm_movemask_ps(mask.raw));
#else
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Floats(), mask, bytes);
  return bytes[0];
#endif
}

HWY_INLINE FloatMask float_mask(WordMask mask) { return hn::RebindMask(Floats(), mask); }
HWY_INLINE WordMask word_mask(FloatMask mask) { return hn::RebindMask(Words(), mask); }
HWY_INLINE WordVec bits_of_floats(FloatVec v) { return hn::BitCast(Words(), v); }
HWY_INLINE FloatVec floats_of_bits(WordVec v) { return hn::BitCast(Floats(), v); }

// Words below 2^31 as floats.
HWY_INLINE FloatVec to_floats(WordVec v) { return hn::ConvertTo(Floats(), hn::BitCast(Ints(), v)); }
// Floats in [0, 2^31), truncated.
HWY_INLINE WordVec to_words(FloatVec v) { return hn::BitCast(Words(), hn::ConvertTo(Ints(), v)); }

// base[index], for indices below 2^31.
HWY_INLINE WordVec gather(const std::uint32_t* base, WordVec index) {
  return hn::GatherIndex(Words(), base, hn::BitCast(Ints(), index));
}

// The 64-bit products of all lanes with one word, in halves.
struct WideProduct {
  WordVec low, high;
};
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE WideProduct multiply_wide(WordVec a, std::uint32_t factor) {
  const std::uint64_t product = std::uint64_t{factor} * hn::GetLane(a);
  return {all_words(static_cast<std::uint32_t>(product)),
          all_words(static_cast<std::uint32_t>(product >> 32))};
}
#else
HWY_INLINE WideProduct multiply_wide(WordVec a, std::uint32_t factor) {
  const hn::RepartitionToWide<Words> d64;
  const Words d;
  const WordVec b = all_words(factor);
  const auto even = hn::MulEven(a, b);
  const auto odd = hn::MulEven(hn::BitCast(d, hn::ShiftRight<32>(hn::BitCast(d64, a))), b);
  return {hn::OddEven(hn::BitCast(d, hn::ShiftLeft<32>(odd)), hn::BitCast(d, even)),
          hn::OddEven(hn::BitCast(d, odd), hn::BitCast(d, hn::ShiftRight<32>(even)))};
}
#endif

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
