// Metal: the mirror direction, and the distribution of the blurred one.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/shading/encounters.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kHeights = 20, kTurns = 24;
constexpr std::uint32_t kSamples = 200'000;
constexpr std::size_t kTests = 40;

TEST(Metal, MirrorReflectsByTheLaw) {
  for (std::uint32_t i = 0; i < 10'000; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 3);
    const auto at = encounter_at(random_normal(i), std::fmax(1e-4, u[0]));
    const auto s = scatter(Metal{{1, 1, 1}, 0}, at, u);
    ASSERT_TRUE(s);
    const Vec3d in(at.direction), n(at.normal), out(s->direction);
    EXPECT_NEAR(length(out), 1, 1e-6);
    EXPECT_NEAR(dot(out, n), -dot(in, n), 5e-7);  // equal angles
    EXPECT_LT(length(cross(out - in, n)), 1e-6);  // in one plane
  }
}

// Density over unit directions of the normalised sum of a unit vector and `fuzz` times a uniform
// point of the unit ball: the ball's density, 3 / (4 pi fuzz^3), integrated with r^2 dr along the
// chord that the direction cuts out of the ball. `cosine` is that to the unit vector.
double blurred_density(double fuzz, double cosine) {
  const double under_root = fuzz * fuzz - (1 - cosine * cosine);
  if (under_root <= 0) return 0;
  const double root = std::sqrt(under_root);
  const double far = cosine + root, near = std::fmax(0, cosine - root);
  if (far <= 0) return 0;
  return (far * far * far - near * near * near) / (4 * kPi * fuzz * fuzz * fuzz);
}

// Expected shares of cells (height above the surface) x (azimuth about the normal, 0 where the
// mirror direction points), by the midpoint rule on a finer grid.
std::vector<double> blurred_cells(double fuzz, double cosine) {
  constexpr int kFine = 40;
  const double sine = std::sqrt(1 - cosine * cosine);
  // Not zero, for cells of which the blur's boundary takes a sliver between the midpoints.
  std::vector<double> cells(kHeights * kTurns, 1e-9);
  for (std::size_t row = 0; row < kHeights * kFine; ++row) {
    const double z = (static_cast<double>(row) + 0.5) / (kHeights * kFine);
    for (std::size_t column = 0; column < kTurns * kFine; ++column) {
      const double turns = (static_cast<double>(column) + 0.5) / (kTurns * kFine) - 0.5;
      const double x = std::sqrt(1 - z * z) * std::cos(2 * kPi * turns);
      cells[row / kFine * kTurns + column / kFine] += blurred_density(fuzz, x * sine + z * cosine) *
                                                      2 * kPi / (kHeights * kTurns * kFine * kFine);
    }
  }
  return cells;
}

std::vector<double> scattered_cells(double fuzz, const Encounter& at, std::uint64_t seed) {
  const Tangents frame = tangents(Vec3d(at.normal), Vec3d(at.direction));
  Histogram cells(kTurns, kHeights);
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto s = scatter(Metal{{1, 1, 1}, fuzz}, at, uniform4(i, 0, 0, 0, seed));
    if (!s) continue;
    const Vec3d d = normalize(Vec3d(s->direction));
    cells.add(std::atan2(dot(d, frame.across), dot(d, frame.along)) / (2 * kPi) + 0.5,
              dot(d, Vec3d(at.normal)));
  }
  return {cells.counts().begin(), cells.counts().end()};
}

// Cells and, as one more, the absorbed.
std::vector<double> with_absorbed(std::vector<double> cells, double total) {
  cells.push_back(std::max(0.0, total - std::accumulate(cells.begin(), cells.end(), 0.0)));
  return cells;
}

// The quadrature is a twentieth of the noise or better; cells that the boundary of the blur only
// grazes expect next to nothing and are pooled.
TEST(Metal, BlurredDirectionsHaveTheDensityOfTheBall) {
  std::uint64_t seed = 500;
  for (const double fuzz : {0.1, 0.5, 0.9, 1.0, 1.7}) {
    for (const double cosine : {0.95, 0.6, 0.25, 0.05}) {
      const auto at = encounter_at(random_normal(static_cast<std::uint32_t>(seed)), cosine);
      const auto observed = with_absorbed(scattered_cells(fuzz, at, ++seed), kSamples);
      const auto expected = with_absorbed(blurred_cells(fuzz, cosine), 1);
      const ChiSquared result = chi_squared_test(observed, expected);
      EXPECT_GT(result.p_value, corrected_significance(kTests))
          << "fuzz " << fuzz << ", cosine " << cosine << ": " << result;
    }
  }
}

// That the test can fail: a point of the sphere in place of the ball, a slightly wrong fuzz.
TEST(Metal, MistakesInTheBlurWouldBeFound) {
  const auto at = encounter_at(random_normal(1), 0.6);
  const auto expected = with_absorbed(blurred_cells(0.5, 0.6), 1);
  const auto wrong_fuzz = with_absorbed(scattered_cells(0.51, at, 1), kSamples);
  EXPECT_LT(chi_squared_test(wrong_fuzz, expected).p_value, corrected_significance(kTests));
  const auto wrong_angle =
      with_absorbed(scattered_cells(0.5, encounter_at(random_normal(1), 0.61), 1), kSamples);
  EXPECT_LT(chi_squared_test(wrong_angle, expected).p_value, corrected_significance(kTests));
}

}  // namespace
}  // namespace dapple::test
