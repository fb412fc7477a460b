#include "tests/statistics/chi_squared.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dapple::test {
namespace {

constexpr double kLeastExpected = 5;
constexpr double kPrecision = 1e-15;

// exp(-x) x^a / Gamma(a), the factor before both expansions of the incomplete gamma function.
double incomplete_gamma_factor(double a, double x) {
  return std::exp(a * std::log(x) - x - std::lgamma(a));
}

// Regularised lower incomplete gamma function P(a, x) by its power series; good for x < a + 1.
double lower_gamma_by_series(double a, double x) {
  double term = 1 / a, sum = term;
  for (double n = a + 1; term > sum * kPrecision; ++n) {
    term *= x / n;
    sum += term;
  }
  return sum * incomplete_gamma_factor(a, x);
}

// Regularised upper incomplete gamma function Q(a, x) by Legendre's continued fraction, evaluated
// by Lentz's method; good for x > a + 1.
double upper_gamma_by_fraction(double a, double x) {
  double b = x + 1 - a;
  double c = 1e300, d = 1 / b, fraction = d;
  for (int n = 1; n < 100'000; ++n) {
    const double numerator = -n * (n - a);
    b += 2;
    d = 1 / (numerator * d + b);
    c = b + numerator / c;
    fraction *= c * d;
    if (std::fabs(c * d - 1) < kPrecision) break;
  }
  return fraction * incomplete_gamma_factor(a, x);
}

}  // namespace

double chi_squared_tail(double statistic, double degrees) {
  const double a = degrees / 2, x = statistic / 2;
  if (!(x > 0)) return 1;
  return x < a + 1 ? 1 - lower_gamma_by_series(a, x) : upper_gamma_by_fraction(a, x);
}

double normal_two_sided_tail(double z) { return std::erfc(std::fabs(z) / std::sqrt(2.0)); }

std::ostream& operator<<(std::ostream& out, const ChiSquared& result) {
  return out << "chi-squared " << result.statistic << " at " << result.degrees
             << " degrees of freedom, p-value " << result.p_value;
}

ChiSquared chi_squared_test(std::span<const double> observed, std::span<const double> expected) {
  const double scale = std::accumulate(observed.begin(), observed.end(), 0.0) /
                       std::accumulate(expected.begin(), expected.end(), 0.0);
  std::vector<std::size_t> by_expectation(observed.size());
  std::iota(by_expectation.begin(), by_expectation.end(), std::size_t{0});
  std::sort(by_expectation.begin(), by_expectation.end(),
            [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });

  ChiSquared result;
  std::size_t bins = 0;
  double pooled_observed = 0, pooled_expected = 0;
  const auto close_bin = [&] {
    const double difference = pooled_observed - pooled_expected;
    result.statistic += difference * difference / pooled_expected;
    ++bins;
    pooled_observed = pooled_expected = 0;
  };
  for (const std::size_t i : by_expectation) {
    if (expected[i] <= 0 && observed[i] > 0) return {HUGE_VAL, 1, 0};
    pooled_observed += observed[i];
    pooled_expected += expected[i] * scale;
    if (pooled_expected >= kLeastExpected) close_bin();
  }
  if (pooled_expected > 0) close_bin();
  result.degrees = bins > 1 ? bins - 1 : 0;
  if (result.degrees > 0) {
    result.p_value = chi_squared_tail(result.statistic, static_cast<double>(result.degrees));
  }
  return result;
}

ChiSquared chi_squared_test_uniform(std::span<const double> observed) {
  return chi_squared_test(observed, std::vector<double>(observed.size(), 1.0));
}

}  // namespace dapple::test
