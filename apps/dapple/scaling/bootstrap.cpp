#include "dapple/scaling/bootstrap.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "math/random.h"

namespace dapple::scaling {
namespace {

constexpr std::uint32_t kDraws = 2000;
constexpr double kTail = 0.025;

std::vector<std::size_t> draw_rounds(std::size_t round_count, std::uint32_t draw) {
  std::vector<std::size_t> rounds(round_count);
  for (std::size_t i = 0; i < round_count; ++i) {
    const PhiloxBlock random = philox4x32({static_cast<std::uint32_t>(i), draw, 0, 0}, 0);
    rounds[i] = std::uint64_t{random[0]} * round_count >> 32;
  }
  return rounds;
}

}  // namespace

double percentile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double median(std::vector<double> values) { return percentile(std::move(values), 0.5); }

std::vector<Estimate> bootstrap(std::size_t round_count, const RoundStatistic& statistic) {
  std::vector<std::size_t> all(round_count);
  std::iota(all.begin(), all.end(), 0);
  const std::vector<double> values = statistic(all);
  std::vector<std::vector<double>> draws(values.size());
  for (std::uint32_t draw = 0; draw < kDraws; ++draw) {
    const std::vector<double> drawn = statistic(draw_rounds(round_count, draw));
    for (std::size_t i = 0; i < values.size(); ++i) draws[i].push_back(drawn[i]);
  }
  std::vector<Estimate> estimates;
  for (std::size_t i = 0; i < values.size(); ++i) {
    estimates.push_back({values[i], percentile(draws[i], kTail), percentile(draws[i], 1 - kTail)});
  }
  return estimates;
}

}  // namespace dapple::scaling
