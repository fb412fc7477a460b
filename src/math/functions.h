// Transcendental functions of our own: glibc picks variants by processor, so its sin, cos and
// pow differ between machines in the last bit. These use only +, -, *, / and integer operations
// and give the same bits everywhere.
#pragma once

namespace dapple {

template <class T>
struct SinCos {
  T sin;
  T cos;
};

// Sine and cosine of 2 pi `turns`; error below 1e-7 (float) and 1e-15 (double) for |turns| <= 2^20.
// Beyond that the double version is right as far as the turns themselves are exact, and takes what
// is not finite for 0; the float version gives rubbish.
[[nodiscard]] SinCos<float> sin_cos_turns(float turns);
[[nodiscard]] SinCos<double> sin_cos_turns(double turns);

// Cube root of x >= 0 (0 for anything else); relative error below 3e-7 (float) and 1e-15 (double).
[[nodiscard]] float cube_root(float x);
[[nodiscard]] double cube_root(double x);

// Logarithm to base 2 of a finite x > 0, not subnormal; error below 1e-15 of the larger of |result|
// and 1.
[[nodiscard]] double binary_log(double x);

// 2^x; relative error below 1e-15. Below -1022 the result is 0, from 1024 on infinity.
[[nodiscard]] double binary_exp(double x);

// x^y for finite x >= 0 and y > 0, by the two above; relative error below 1e-15 (1 + |y log2 x|).
[[nodiscard]] double power(double x, double y);

// Radians in [0, pi]; x is clamped to [-1, 1]; error below 3e-8.
[[nodiscard]] double arc_cosine(double x);

}  // namespace dapple
