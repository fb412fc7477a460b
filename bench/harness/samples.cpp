#include "harness/samples.h"

#include <algorithm>

namespace dapple::bench {

std::vector<double> Samples::seconds() const {
  std::vector<double> result;
  for (const Seconds& run : runs) result.push_back(cores == Cores::one ? run.cpu : run.wall);
  return result;
}

double Samples::median() const { return median_of(seconds()); }

double Samples::spread() const {
  const std::vector<double> all = seconds();
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  return (*high - *low) / median_of(all);
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Ratio time_ratio(const Samples& slow, const Samples& fast) {
  const std::vector<double> a = slow.seconds(), b = fast.seconds();
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) ratios.push_back(a[i] / b[i]);
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  return {median_of(a) / median_of(b), *low, *high};
}

}  // namespace dapple::bench
