// White furnace: under uniform light from everywhere a surface shows its albedo, and what a
// material loses is what its definition says.
#include <gtest/gtest.h>

#include "tests/shading/encounters.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

constexpr std::uint32_t kSamples = 100'000;
constexpr std::size_t kTests = 100;

struct Furnace {
  Vec3d radiance;          // mean attenuation
  double scattered_share;  // of the rays
};

Furnace furnace(const Material& material, const Encounter& at, std::uint64_t seed) {
  Furnace result{};
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto scattered = scatter(material, at, uniform4(i, 0, 0, 0, seed));
    if (!scattered) continue;
    result.radiance = result.radiance + Vec3d(scattered->attenuation) / double{kSamples};
    result.scattered_share += 1.0 / kSamples;
  }
  return result;
}

constexpr double kCosines[] = {1, 0.9, 0.6, 0.3, 0.1, 0.01};

TEST(WhiteFurnace, LambertianReturnsExactlyItsAlbedo) {
  for (const Vec3d& albedo : {Vec3d(1, 1, 1), Vec3d(0.25, 0.5, 0)}) {
    for (const double cosine : kCosines) {
      const Furnace f = furnace(Lambertian{albedo}, encounter_at(random_normal(1), cosine), 1);
      EXPECT_NEAR(f.scattered_share, 1, 1e-9);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(f.radiance[c], albedo[c], 1e-9);
    }
  }
}

TEST(WhiteFurnace, PerfectMirrorReturnsExactlyItsAlbedo) {
  for (const double cosine : kCosines) {
    const Furnace f = furnace(Metal{{1, 0.5, 0}, 0}, encounter_at(random_normal(2), cosine), 2);
    EXPECT_NEAR(f.radiance.x, 1, 1e-9);
    EXPECT_NEAR(f.radiance.y, 0.5, 1e-9);
    EXPECT_EQ(f.radiance.z, 0);
  }
}

TEST(WhiteFurnace, DielectricAbsorbsNothing) {
  for (const double ref_idx : {1.0, 1.33, 1.5, 2.4, 0.7}) {
    for (const double cosine : kCosines) {
      for (const bool outside : {true, false}) {
        const auto at = encounter_at(random_normal(3), cosine, outside);
        const Furnace f = furnace(Dielectric{ref_idx}, at, 3);
        EXPECT_NEAR(f.radiance.x, 1, 1e-9);
        EXPECT_NEAR(f.scattered_share, 1, 1e-9);
      }
    }
  }
}

// The blurred direction points below the surface where the ball of radius fuzz around the
// mirror direction, of height cos above the surface, reaches below it: a spherical cap.
double absorbed_share(double fuzz, double cosine) {
  const double h = cosine / fuzz;
  return h >= 1 ? 0 : (1 - h) * (1 - h) * (2 + h) / 4;
}

TEST(WhiteFurnace, FuzzyMetalLosesTheCapBelowTheSurface) {
  std::uint64_t seed = 100;
  for (const double fuzz : {0.1, 0.3, 0.9, 1.0, 2.0}) {
    for (const double cosine : kCosines) {
      const auto at = encounter_at(random_normal(static_cast<std::uint32_t>(seed)), cosine);
      const Furnace f = furnace(Metal{{1, 1, 1}, fuzz}, at, ++seed);
      const double lost = absorbed_share(fuzz, cosine);
      const double counts[] = {f.scattered_share * kSamples, (1 - f.scattered_share) * kSamples};
      const double expected[] = {1 - lost, lost};
      const double lost_count = counts[1];
      if (lost == 0) {
        EXPECT_LT(lost_count, 0.5) << fuzz << " " << cosine;
      } else {
        const ChiSquared result = chi_squared_test(counts, expected);
        EXPECT_GT(result.p_value, corrected_significance(kTests))
            << "fuzz " << fuzz << ", cosine " << cosine << ": " << result;
      }
    }
  }
}

// The material sees which side the ray came from only through the normal.
TEST(Scatter, MattAndMetalAreTheSameFromBothSides) {
  const Material materials[] = {Lambertian{{0.3, 0.6, 0.9}}, Metal{{0.3, 0.6, 0.9}, 0.7}};
  for (const Material& material : materials) {
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const auto u = uniform4(i, 5, 0, 0, 5);
      const auto at = encounter_at(random_normal(i), 0.05 + 0.9 * u[3]);
      const auto outside = scatter(material, at, u);
      const auto inside = scatter(material, {at.direction, at.normal, false}, u);
      ASSERT_EQ(outside.has_value(), inside.has_value());
      EXPECT_TRUE(!outside || outside->direction == inside->direction);
    }
  }
}

TEST(Scatter, MattDirectionsAreCosineWeighted) {
  for (std::uint32_t k = 0; k < 4; ++k) {
    const auto at = encounter_at(random_normal(k + 50), 0.2 + 0.2 * k, k % 2 == 0);
    const Tangents frame = tangents(Vec3d(at.normal), Vec3d(at.direction));
    Histogram polar(24, 24);
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      const auto s = scatter(Lambertian{{1, 1, 1}}, at, uniform4(i, k, 0, 0, 6));
      ASSERT_TRUE(s);
      const Vec3d d = normalize(Vec3d(s->direction));
      const double cosine = dot(d, Vec3d(at.normal));
      const double turns =
          std::atan2(dot(d, frame.across), dot(d, frame.along)) / 6.283185307179586;
      polar.add(turns + 0.5, 1 - cosine * cosine);
    }
    const ChiSquared result = chi_squared_test_uniform(polar.counts());
    EXPECT_GT(result.p_value, corrected_significance(kTests)) << result;
  }
}

}  // namespace
}  // namespace dapple::test
