// fast_functions.h on vectors, operation for operation.
#include "math/fast_functions.h"
#include "math/warps-inl.h"

#if defined(DAPPLE_MATH_FAST_FUNCTIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_MATH_FAST_FUNCTIONS_INL_H
#undef DAPPLE_MATH_FAST_FUNCTIONS_INL_H
#else
#define DAPPLE_MATH_FAST_FUNCTIONS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

HWY_INLINE FloatVec fast_atan_unit(FloatVec x) {
  const FloatVec one = all(1.0f);
  const FloatMask large = hn::Gt(x, all(0.414213562f));
  const FloatVec t = hn::IfThenElse(large, hn::Div(hn::Sub(x, one), hn::Add(x, one)), x);
  const FloatVec t2 = hn::Mul(t, t);
  const FloatVec series = horner(t2, -0.333327614f, 0.199720154f, -0.138256420f, 0.0790585407f);
  const FloatVec p = hn::Add(t, hn::Mul(hn::Mul(t, t2), series));
  return hn::IfThenElse(large, hn::Add(all(0.785398163397448f), p), p);
}

HWY_INLINE FloatVec fast_atan2(FloatVec y, FloatVec x) {
  const FloatVec zero = hn::Zero(Floats());
  const FloatVec ax = hn::Abs(x), ay = hn::Abs(y);
  const FloatVec over = larger(ax, ay), under = smaller(ay, ax);
  FloatVec angle = fast_atan_unit(hn::Div(under, over));
  angle = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(all(1.57079632679490f), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(all(kPi), angle), angle);
  angle = hn::IfThenElse(hn::Lt(y, zero), hn::Neg(angle), angle);
  return hn::IfThenElseZero(hn::Gt(over, zero), angle);
}

HWY_INLINE FloatVec fast_acos(FloatVec x) {
  const FloatVec one = all(1.0f);
  const FloatVec squared = hn::Mul(hn::Sub(one, x), hn::Add(one, x));
  return fast_atan2(hn::Sqrt(larger(squared, hn::Zero(Floats()))), x);
}

HWY_INLINE FloatVec fast_exp2(FloatVec x) {
  const FloatVec bounded = smaller(all(127.0f), x);
  const FloatVec whole = hn::Floor(hn::Add(bounded, all(0.5f)));
  const FloatVec t = hn::Mul(hn::Sub(bounded, whole), all(0.693147180559945f));
  const FloatVec p = horner(t, 1.0f, 1.0f, 0.5f, 1.0f / 6, 1.0f / 24, 1.0f / 120, 1.0f / 720);
  const WordVec exponent =
      hn::Add(hn::BitCast(Words(), hn::ConvertTo(Ints(), whole)), all_words(127));
  const FloatVec result = hn::Mul(p, floats_of_bits(hn::ShiftLeft<23>(exponent)));
  return hn::IfThenElseZero(hn::Gt(x, all(-126.0f)), result);
}

HWY_INLINE FloatVec fast_log2(FloatVec x) {
  const FloatVec one = all(1.0f);
  const WordVec sqrt_half = all_words(0x3f3504f3u);
  const WordVec shifted = hn::Sub(bits_of_floats(x), sqrt_half);
  const FloatVec exponent =
      hn::ConvertTo(Floats(), hn::ShiftRight<23>(hn::BitCast(Ints(), shifted)));
  const FloatVec m = floats_of_bits(hn::Add(hn::And(shifted, all_words(0x007fffffu)), sqrt_half));
  const FloatVec s = hn::Div(hn::Sub(m, one), hn::Add(m, one));
  const FloatVec s2 = hn::Mul(s, s);
  FloatVec series = hn::Add(all(1.0f / 7), hn::Div(s2, all(9.0f)));
  series = hn::Add(all(1.0f / 5), hn::Mul(s2, series));
  series = hn::Add(all(1.0f / 3), hn::Mul(s2, series));
  series = hn::Add(one, hn::Mul(s2, series));
  return hn::Add(exponent, hn::Mul(hn::Mul(all(2.88539008177793f), s), series));
}

HWY_INLINE FloatVec fast_exp(FloatVec x) { return fast_exp2(hn::Mul(x, all(1.44269504088896f))); }

HWY_INLINE FloatVec fast_pow(FloatVec x, FloatVec y) {
  const FloatVec result = fast_exp2(hn::Mul(y, fast_log2(x)));
  return hn::IfThenZeroElse(hn::Lt(x, all(1.17549435e-38f)), result);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
