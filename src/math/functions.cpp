#include "math/functions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "math/fast_functions.h"

namespace dapple {
namespace {

// Taylor series of sin and cos on [-pi/4, pi/4], by Horner's rule in x^2. The number of terms
// makes the first one left out smaller than half a unit in the last place of T.
template <class T>
T sin_series(T x, int last) {
  const T x2 = x * x;
  T sum = 1;
  for (int n = last; n > 0; --n) sum = T(1) - x2 / T(2 * n * (2 * n + 1)) * sum;
  return x * sum;
}

template <class T>
T cos_series(T x, int last) {
  const T x2 = x * x;
  T sum = 1;
  for (int n = last; n > 0; --n) sum = T(1) - x2 / T(2 * n * (2 * n - 1)) * sum;
  return sum;
}

// The part of a turn, where there are more turns than an integer can count with certainty; none of
// what is not finite.
double part_of_turn(double turns) { return std::isfinite(turns) ? turns - std::floor(turns) : 0; }

template <class T>
SinCos<T> by_quadrants(T turns, int terms) {
  if (!(std::fabs(turns) <= T(1 << 20))) turns = part_of_turn(turns);
  const T quarter_turns = turns * T(4);
  const T nearest = std::floor(quarter_turns + T(0.5));
  const T angle = (quarter_turns - nearest) * T(1.57079632679489661923);
  const T s = sin_series(angle, terms);
  const T c = cos_series(angle, terms + 1);
  switch (static_cast<std::int64_t>(nearest) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

// Each Halley step for r^3 = x triples the number of right digits.
template <class T>
T halley_cube_root(T x, T r, int steps) {
  for (int step = 0; step < steps; ++step) {
    const T r3 = r * r * r;
    r = r * (r3 + T(2) * x) / (T(2) * r3 + x);
  }
  return r;
}

}  // namespace

SinCos<float> sin_cos_turns(float turns) {
  // Polynomials with constant coefficients 1/n!, and no branch: the float version is called for
  // every bounce, and its quadrants are random.
  const float quarter_turns = turns * 4.0f;
  const std::int32_t nearest = floor_to_int(quarter_turns + 0.5f);
  const float x = (quarter_turns - static_cast<float>(nearest)) * 1.57079632679f;
  const float x2 = x * x;
  const float s =
      x *
      (1.0f + x2 * (-1.0f / 6 + x2 * (1.0f / 120 + x2 * (-1.0f / 5040 + x2 * (1.0f / 362880)))));
  const float c = 1.0f + x2 * (-0.5f + x2 * (1.0f / 24 + x2 * (-1.0f / 720 + x2 * (1.0f / 40320))));
  // Odd quadrants exchange the two; the sine is negative in quadrants 2 and 3, the cosine in 1 and
  // 2.
  const auto quadrant = static_cast<std::uint32_t>(nearest);
  const auto s_bits = std::bit_cast<std::uint32_t>(s), c_bits = std::bit_cast<std::uint32_t>(c);
  const std::uint32_t exchanged = (s_bits ^ c_bits) & (0u - (quadrant & 1u));
  return {std::bit_cast<float>((s_bits ^ exchanged) ^ (quadrant & 2u) << 30),
          std::bit_cast<float>((c_bits ^ exchanged) ^ ((quadrant + 1u) & 2u) << 30)};
}

SinCos<double> sin_cos_turns(double turns) { return by_quadrants(turns, 8); }

float cube_root(float x) {
  if (!(x > 0.0f)) return 0.0f;
  // Dividing the exponent by three starts within 6 %.
  const float start = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) / 3 + 0x2a514067u);
  return halley_cube_root(x, start, 2);
}

double cube_root(double x) {
  if (!(x > 0.0)) return 0.0;
  const auto bits = std::bit_cast<std::uint64_t>(x) / 3 + 0x2a9f7893'00000000u;
  return halley_cube_root(x, std::bit_cast<double>(bits), 3);
}

double binary_log(double x) {
  constexpr double kTwoOverLn2 = 2.88539008177792681472;
  constexpr int kTerms = 11;  // the first one left out is below 2^-60
  // x = 2^exponent * m with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh((m - 1) / (m + 1)).
  constexpr std::uint64_t kSqrtHalf = 0x3fe6a09e'667f3bcdu;
  constexpr std::uint64_t kMantissa = 0x000fffff'ffffffffu;
  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) - kSqrtHalf;
  const auto exponent = static_cast<double>(static_cast<std::int64_t>(shifted) >> 52);
  const double m = std::bit_cast<double>((shifted & kMantissa) + kSqrtHalf);
  const double s = (m - 1) / (m + 1);
  const double s2 = s * s;
  double sum = 0;
  for (int n = kTerms; n >= 0; --n) sum = 1.0 / (2 * n + 1) + s2 * sum;
  return exponent + kTwoOverLn2 * s * sum;
}

double binary_exp(double x) {
  constexpr double kLn2 = 0.693147180559945309417;
  constexpr int kTerms = 15;
  if (!(x >= -1022)) return 0;
  if (x >= 1024) return std::numeric_limits<double>::infinity();
  const double whole = std::floor(x + 0.5);
  const double t = (x - whole) * kLn2;
  double sum = 1;
  for (int n = kTerms; n > 0; --n) sum = 1 + t / n * sum;
  // Half the scale twice: 2^1024 is no double, though 2^1023.9 is.
  const auto half = static_cast<std::int64_t>(whole) / 2;
  const auto scale = [](std::int64_t e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  };
  return sum * scale(half) * scale(static_cast<std::int64_t>(whole) - half);
}

double power(double x, double y) {
  if (!(x >= std::numeric_limits<double>::min())) return 0;
  return binary_exp(y * binary_log(x));
}

// Polynomial 4.4.46 of Abramowitz and Stegun; error below 2e-8.
double arc_cosine(double x) {
  const double a = std::clamp(std::fabs(x), 0.0, 1.0);
  constexpr double kCoefficients[] = {1.5707963050, -0.2145988016, 0.0889789874, -0.0501743046,
                                      0.0308918810, -0.0170881256, 0.0066700901, -0.0012624911};
  double sum = 0;
  for (std::size_t i = std::size(kCoefficients); i-- > 0;) sum = sum * a + kCoefficients[i];
  const double angle = std::sqrt(1 - a) * sum;
  return x < 0 ? 3.14159265358979323846 - angle : angle;
}

}  // namespace dapple
