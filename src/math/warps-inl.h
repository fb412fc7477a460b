// functions.h and warps.h on vectors, operation for operation.
#include "math/simd-inl.h"

#if defined(DAPPLE_MATH_WARPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_MATH_WARPS_INL_H
#undef DAPPLE_MATH_WARPS_INL_H
#else
#define DAPPLE_MATH_WARPS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct SinCosVec {
  FloatVec sin, cos;
};

// c0 + x (c1 + x (...)), by Horner's rule.
HWY_INLINE FloatVec horner(FloatVec /*x*/, float c) { return all(c); }
template <class... Rest>
HWY_INLINE FloatVec horner(FloatVec x, float c, Rest... rest) {
  return hn::Add(all(c), hn::Mul(x, horner(x, rest...)));
}

// Of the angle x in [-pi/4, pi/4] plus `quadrant` right angles.
HWY_INLINE SinCosVec sin_cos_of_quadrant(FloatVec x, WordVec quadrant) {
  const FloatVec x2 = hn::Mul(x, x);
  const FloatVec s =
      hn::Mul(x, horner(x2, 1.0f, -1.0f / 6, 1.0f / 120, -1.0f / 5040, 1.0f / 362880));
  const FloatVec c = horner(x2, 1.0f, -0.5f, 1.0f / 24, -1.0f / 720, 1.0f / 40320);
  const WordVec one = all_words(1), two = all_words(2);
  const FloatMask swapped = float_mask(hn::Eq(hn::And(quadrant, one), one));
  // The sine is negative in quadrants 2 and 3, the cosine in 1 and 2.
  const WordVec sin_sign = hn::ShiftLeft<30>(hn::And(quadrant, two));
  const WordVec cos_sign = hn::ShiftLeft<30>(hn::And(hn::Add(quadrant, one), two));
  return {hn::Xor(hn::IfThenElse(swapped, c, s), floats_of_bits(sin_sign)),
          hn::Xor(hn::IfThenElse(swapped, s, c), floats_of_bits(cos_sign))};
}

// For turns in [0, 2^20].
HWY_INLINE SinCosVec sin_cos_turns(FloatVec turns) {
  const FloatVec quarter_turns = hn::Mul(turns, all(4.0f));
  const WordVec quadrant = to_words(hn::Add(quarter_turns, all(0.5f)));
  return sin_cos_of_quadrant(
      hn::Mul(hn::Sub(quarter_turns, to_floats(quadrant)), all(1.57079632679f)), quadrant);
}

HWY_INLINE FloatVec halley_step(FloatVec x, FloatVec r) {
  const FloatVec r3 = hn::Mul(hn::Mul(r, r), r);
  const FloatVec above = hn::Mul(r, hn::Add(r3, hn::Mul(all(2.0f), x)));
  return hn::Div(above, hn::Add(hn::Mul(all(2.0f), r3), x));
}

HWY_INLINE FloatVec cube_root(FloatVec x) {
  // A third of the bits: multiplying by 2/3 of 2^32, rounded up, divides all words rightly.
  const WordVec third = hn::ShiftRight<1>(multiply_wide(bits_of_floats(x), 0xAAAAAAABu).high);
  const FloatVec start = floats_of_bits(hn::Add(third, all_words(0x2a514067u)));
  const FloatVec root = halley_step(x, halley_step(x, start));
  return hn::IfThenElseZero(hn::Gt(x, hn::Zero(Floats())), root);
}

// The point of the plane z = 0.
struct DiscPoint {
  FloatVec x, y;
};
HWY_INLINE DiscPoint sample_uniform_disc(FloatVec u, FloatVec v) {
  const FloatVec r = hn::Sqrt(u);
  const SinCosVec angle = sin_cos_turns(v);
  return {hn::Mul(r, angle.cos), hn::Mul(r, angle.sin)};
}

HWY_INLINE FloatVec3 sample_uniform_sphere(FloatVec u, FloatVec v) {
  const FloatVec z = hn::Sub(all(1.0f), hn::Mul(all(2.0f), u));
  const FloatVec squared = hn::Sub(all(1.0f), hn::Mul(z, z));
  const FloatVec r = hn::Sqrt(larger(squared, hn::Zero(Floats())));
  const SinCosVec angle = sin_cos_turns(v);
  return {hn::Mul(r, angle.cos), hn::Mul(r, angle.sin), z};
}

// The cosine-weighted direction around n that a point of the unit sphere stands for.
HWY_INLINE FloatVec3 cosine_direction(FloatVec3 n, FloatVec3 sphere_point) {
  const FloatVec3 direction = n + sphere_point;
  const FloatVec squared = dot(direction, direction);
  return select(hn::Gt(squared, all(1e-12f)), direction / hn::Sqrt(squared), n);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
