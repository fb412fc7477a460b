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
[[nodiscard]] SinCos<float> sin_cos_turns(float turns);
[[nodiscard]] SinCos<double> sin_cos_turns(double turns);

// Cube root of x >= 0 (0 for anything else); relative error below 3e-7 (float) and 1e-15 (double).
[[nodiscard]] float cube_root(float x);
[[nodiscard]] double cube_root(double x);

}  // namespace dapple
