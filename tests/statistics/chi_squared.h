// Goodness of fit: does a histogram come from the distribution that it should come from?
#pragma once

#include <cstddef>
#include <ostream>
#include <span>
#include <vector>

namespace dapple::test {

// Chance that one family of tests fails although nothing is wrong. The seeds of tests are fixed,
// so a test that passes once always passes.
inline constexpr double kSignificance = 1e-3;

// The level for each of `tests` tests that makes kSignificance that of all together (Bonferroni).
constexpr double corrected_significance(std::size_t tests) {
  return kSignificance / static_cast<double>(tests);
}

// Probability that a chi-squared variable of that many degrees of freedom is at least `statistic`.
[[nodiscard]] double chi_squared_tail(double statistic, double degrees);

// Probability that a standard normal variable is at least |z| from zero.
[[nodiscard]] double normal_two_sided_tail(double z);

struct ChiSquared {
  double statistic = 0;
  std::size_t degrees = 0;
  double p_value = 1;  // probability of a fit this bad or worse
};
std::ostream& operator<<(std::ostream& out, const ChiSquared& result);

// Pearson's test of counts against their expectations, which need not be normalised: they are
// scaled to the same total. Bins that expect fewer than five are pooled, smallest first. A count
// where nothing is possible has p-value zero.
[[nodiscard]] ChiSquared chi_squared_test(std::span<const double> observed,
                                          std::span<const double> expected);
[[nodiscard]] ChiSquared chi_squared_test_uniform(std::span<const double> observed);

// Counts over a grid of equal cells of the unit square (or of the unit interval, rows = 1).
class Histogram {
 public:
  explicit Histogram(std::size_t columns, std::size_t rows = 1)
      : columns_(columns), rows_(rows), counts_(columns * rows) {}

  // u and v in [0, 1]; what rounding puts outside counts in the nearest cell.
  void add(double u, double v = 0) { ++counts_[cell(v, rows_) * columns_ + cell(u, columns_)]; }

  std::span<const double> counts() const { return counts_; }

 private:
  static std::size_t cell(double u, std::size_t cells) {
    if (!(u > 0)) return 0;
    const auto index = static_cast<std::size_t>(u * static_cast<double>(cells));
    return index < cells ? index : cells - 1;
  }

  std::size_t columns_;
  std::size_t rows_;
  std::vector<double> counts_;
};

}  // namespace dapple::test
