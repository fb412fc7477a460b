// Single-precision elementary functions for inner loops: polynomials, inlined, the same bits on
// every machine. Arguments outside the stated ranges give finite rubbish unless said otherwise.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "math/functions.h"

namespace dapple {

inline constexpr float kPi = 3.14159265358979323846f;
inline constexpr float kInvPi = 0.318309886183790671538f;

// The largest integer not above x, |x| < 2^31; without the call that std::floor is before SSE4.1.
inline std::int32_t floor_to_int(float x) {
  const auto truncated = static_cast<std::int32_t>(x);
  return truncated - (static_cast<float>(truncated) > x ? 1 : 0);
}

// 2^x; relative error below 2e-7. Below -126 the result is 0, above 127 it is 2^127.
inline float fast_exp2(float x) {
  if (!(x > -126.0f)) return 0.0f;
  if (x > 127.0f) x = 127.0f;
  const std::int32_t whole = floor_to_int(x + 0.5f);
  const float t = (x - static_cast<float>(whole)) * 0.693147180559945f;  // in +-ln(2) / 2
  const float p =
      1.0f + t * (1.0f + t * (0.5f + t * (1.0f / 6 +
                                          t * (1.0f / 24 + t * (1.0f / 120 + t * (1.0f / 720))))));
  return p * std::bit_cast<float>(static_cast<std::uint32_t>(whole + 127) << 23);
}

// Logarithm to base 2 of a normal x > 0; error below 2e-7 of the larger of |result| and 1.
inline float fast_log2(float x) {
  constexpr std::uint32_t kSqrtHalf = 0x3f3504f3u;
  const std::uint32_t shifted = std::bit_cast<std::uint32_t>(x) - kSqrtHalf;
  const auto exponent = static_cast<float>(static_cast<std::int32_t>(shifted) >> 23);
  const float m = std::bit_cast<float>((shifted & 0x007fffffu) + kSqrtHalf);
  const float s = (m - 1.0f) / (m + 1.0f);  // ln m = 2 artanh s, |s| < 0.172
  const float s2 = s * s;
  return exponent + 2.88539008177793f * s *
                        (1.0f + s2 * (1.0f / 3 + s2 * (1.0f / 5 + s2 * (1.0f / 7 + s2 / 9))));
}

inline float fast_exp(float x) { return fast_exp2(x * 1.44269504088896f); }
inline float fast_log(float x) { return fast_log2(x) * 0.693147180559945f; }

// x^y for x >= 0, 0 where x is 0 or subnormal.
inline float fast_pow(float x, float y) {
  return x < 1.17549435e-38f ? 0.0f : fast_exp2(y * fast_log2(x));
}

// Arctangent of x in [0, 1]; error below 2e-7. The polynomial is fitted by least squares.
inline float fast_atan_unit(float x) {
  // Above tan(pi / 8) the identity atan x = pi / 4 + atan((x - 1) / (x + 1)) halves the range.
  const bool large = x > 0.414213562f;
  const float t = large ? (x - 1.0f) / (x + 1.0f) : x;
  const float t2 = t * t;
  const float p =
      t +
      t * t2 * (-0.333327614f + t2 * (0.199720154f + t2 * (-0.138256420f + t2 * 0.0790585407f)));
  return large ? 0.785398163397448f + p : p;
}

// The angle of (x, y) from the x axis in [-pi, pi]; error below 4e-7. 0 for the null vector.
inline float fast_atan2(float y, float x) {
  const float ax = std::fabs(x), ay = std::fabs(y);
  const float larger = ax > ay ? ax : ay, smaller = ax > ay ? ay : ax;
  if (!(larger > 0.0f)) return 0.0f;
  float angle = fast_atan_unit(smaller / larger);
  if (ay > ax) angle = 1.57079632679490f - angle;
  if (x < 0.0f) angle = kPi - angle;
  return y < 0.0f ? -angle : angle;
}

// Arccosine of x, clamped to [-1, 1]; error below 4e-7.
inline float fast_acos(float x) {
  const float squared = (1.0f - x) * (1.0f + x);
  return fast_atan2(std::sqrt(squared > 0.0f ? squared : 0.0f), x);
}

// Sine and cosine of an angle in radians; error below 3e-7 for |angle| <= 100.
inline SinCos<float> sin_cos(float angle) { return sin_cos_turns(angle * 0.159154943091895f); }

}  // namespace dapple
