// Glass: Snell's law, total internal reflection, Schlick's share of reflection, and the way back.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shading/encounters.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

constexpr double kIndices[] = {1.1, 1.33, 1.5, 2.4, 0.75};
constexpr std::size_t kTests = 60;
// Numbers that choose refraction wherever it is possible, and reflection wherever it can be.
constexpr std::array<float, 4> kRefract = {1 - 0x1p-24f, 0, 0, 0};
constexpr std::array<float, 4> kReflect = {0, 0, 0, 0};

double index_ratio(double ref_idx, bool outside) { return outside ? 1 / ref_idx : ref_idx; }

double head_on_reflectance(double ref_idx) { return std::pow((ref_idx - 1) / (ref_idx + 1), 2); }

bool refracted(const Scattered& s, const Encounter& at) { return dot(s.direction, at.normal) < 0; }

// Within this of the critical angle the cosine of refraction loses half its digits.
bool near_critical(double ratio, double sine) { return std::fabs(ratio * sine - 1) < 1e-4; }

TEST(Dielectric, RefractsBySnellsLaw) {
  for (const double ref_idx : kIndices) {
    for (std::uint32_t i = 0; i < 4000; ++i) {
      const auto u = uniform4(i, 0, 0, 0, 11);
      const bool outside = i % 2 == 0;
      const auto at = encounter_at(random_normal(i), std::fmax(1e-3, u[0]), outside);
      const Vec3d in(at.direction), n(at.normal);
      const double ratio = index_ratio(ref_idx, outside);
      const double sine = length(cross(in, n));
      if (ratio * sine > 1 || near_critical(ratio, sine)) continue;
      const auto s = scatter(Dielectric{ref_idx}, at, kRefract);
      ASSERT_TRUE(s);
      if (!refracted(*s, at)) continue;  // the chosen number is not above every reflectance
      const Vec3d out(s->direction);
      // Single precision: the error of the cosine grows with its inverse.
      const double cosine = std::sqrt(1 - ratio * ratio * sine * sine);
      const double tolerance = 2e-6 * std::fmax(1, ratio * ratio) / cosine;
      EXPECT_NEAR(length(out), 1, tolerance);
      EXPECT_NEAR(length(cross(out, n)), ratio * sine, 2e-6 * ratio);
      EXPECT_NEAR(dot(out, cross(in, n)), 0, 2e-6);  // in the plane of incidence
      EXPECT_GE(dot(out, in), -1e-6);
      EXPECT_TRUE(sine < 1e-3 || dot(out - dot(out, n) * n, in - dot(in, n) * n) > 0);
    }
  }
}

TEST(Dielectric, ReflectsTotallyBeyondTheCriticalAngleOnly) {
  for (const double ref_idx : kIndices) {
    const bool outside = ref_idx < 1;  // the ray comes from the denser side
    const double critical_sine = ref_idx < 1 ? ref_idx : 1 / ref_idx;
    for (const double beyond : {-0.01, -1e-3, -1e-5, 1e-5, 1e-3, 0.01}) {
      const double sine = critical_sine * (1 + beyond);
      for (std::uint32_t k = 0; k < 50; ++k) {
        const auto at = encounter_at(random_normal(k), std::sqrt(1 - sine * sine), outside);
        const auto s = scatter(Dielectric{ref_idx}, at, kRefract);
        ASSERT_TRUE(s);
        EXPECT_EQ(refracted(*s, at), beyond < 0) << ref_idx << " " << beyond;
        const Vec3d mirrored =
            Vec3d(at.direction) - 2 * dot(Vec3d(at.direction), Vec3d(at.normal)) * Vec3d(at.normal);
        EXPECT_TRUE(beyond < 0 || length(Vec3d(s->direction) - mirrored) < 1e-6);
      }
    }
  }
}

TEST(Dielectric, SchlickAtNormalAndGrazingIncidence) {
  for (const double ref_idx : kIndices) {
    const auto n = static_cast<float>(ref_idx);
    EXPECT_NEAR(schlick_reflectance(1, n), head_on_reflectance(ref_idx), 1e-7);
    EXPECT_EQ(schlick_reflectance(0, n), 1);
    for (float c = 0; c < 1; c += 0.01f) {
      EXPECT_GE(schlick_reflectance(c, n), schlick_reflectance(c + 0.01f, n)) << "must fall";
    }
  }
}

// Schlick's formula with the cosine on the thinner side, from either side.
double expected_reflectance(double ref_idx, bool outside, double cosine) {
  const double ratio = index_ratio(ref_idx, outside);
  const double sine_out = ratio * std::sqrt(1 - cosine * cosine);
  if (sine_out > 1) return 1;
  const double thinner = std::fmin(cosine, std::sqrt(1 - sine_out * sine_out));
  const double r0 = head_on_reflectance(ref_idx);
  return r0 + (1 - r0) * std::pow(1 - thinner, 5);
}

TEST(Dielectric, ReflectsAsOftenAsSchlickSays) {
  constexpr std::uint32_t kSamples = 100'000;
  std::uint64_t seed = 0;
  for (const double ref_idx : kIndices) {
    for (const double cosine : {1.0, 0.8, 0.5, 0.2, 0.05}) {
      for (const bool outside : {true, false}) {
        const auto at = encounter_at(random_normal(4), cosine, outside);
        double counts[2] = {};
        ++seed;
        for (std::uint32_t i = 0; i < kSamples; ++i) {
          const auto s = scatter(Dielectric{ref_idx}, at, uniform4(i, 0, 0, 0, seed));
          ++counts[refracted(*s, at)];
        }
        const double share = expected_reflectance(ref_idx, outside, cosine);
        const double expected[] = {share, 1 - share};
        const ChiSquared result = chi_squared_test(counts, expected);
        EXPECT_GT(result.p_value, corrected_significance(kTests))
            << ref_idx << ", cosine " << cosine << ", outside " << outside << ": " << result;
      }
    }
  }
}

// The share of reflection that scatter() uses, found by bisection.
double reflectance(double ref_idx, const Encounter& at) {
  float low = 0, high = 1;
  for (int step = 0; step < 30; ++step) {
    const float middle = 0.5f * (low + high);
    const bool through = refracted(*scatter(Dielectric{ref_idx}, at, {middle, 0, 0, 0}), at);
    (through ? high : low) = middle;
  }
  return high;
}

// Light can go back the way it came: into the glass, turned round, it leaves along itself; and
// the share of reflection is the same from both sides.
TEST(Dielectric, RefractionIsReversible) {
  for (const double ref_idx : kIndices) {
    for (std::uint32_t i = 0; i < 2000; ++i) {
      const auto u = uniform4(i, 0, 0, 0, 12);
      const auto in = encounter_at(random_normal(i), 0.1 + 0.9 * u[0], ref_idx > 1);
      const auto through = scatter(Dielectric{ref_idx}, in, kRefract);
      ASSERT_TRUE(through && refracted(*through, in));
      const Encounter back{-through->direction, -in.normal, !in.from_outside};
      const auto out = scatter(Dielectric{ref_idx}, back, kRefract);
      ASSERT_TRUE(out);
      EXPECT_LT(length(out->direction + in.direction), 2e-5);
      EXPECT_NEAR(reflectance(ref_idx, in), reflectance(ref_idx, back), 5e-5);
    }
  }
}

// A pane with parallel faces only shifts the ray.
TEST(Dielectric, ParallelSlabKeepsTheDirection) {
  for (const double ref_idx : kIndices) {
    for (std::uint32_t i = 0; i < 2000; ++i) {
      const auto u = uniform4(i, 0, 0, 0, 13);
      const auto in = encounter_at(random_normal(i), 0.1 + 0.9 * u[0]);
      const auto inside = scatter(Dielectric{ref_idx}, in, kRefract);
      ASSERT_TRUE(inside);
      if (!refracted(*inside, in)) continue;  // total reflection where ref_idx < 1
      // The far face's outward normal points the other way; the ray meets it from inside.
      const auto out =
          scatter(Dielectric{ref_idx}, {inside->direction, in.normal, false}, kRefract);
      ASSERT_TRUE(out);
      EXPECT_LT(length(out->direction - in.direction), 2e-5);
    }
  }
}

// Index 1 is no surface at all, index infinity a mirror.
TEST(Dielectric, LimitsOfTheIndex) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 14);
    const auto at = encounter_at(random_normal(i), 0.05 + 0.95 * u[0]);
    const auto nothing = scatter(Dielectric{1}, at, kRefract);
    EXPECT_LT(length(nothing->direction - at.direction), 1e-6);
    EXPECT_FALSE(refracted(*scatter(Dielectric{1.5}, at, kReflect), at));
  }
}

}  // namespace
}  // namespace dapple::test
