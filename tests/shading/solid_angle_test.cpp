#include "shading/solid_angle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "tests/shading/lit_room.h"
#include "tests/statistics/chi_squared.h"

namespace dapple::test {
namespace {

constexpr double kExactPi = 3.14159265358979323846;

struct View {
  Vec3f corner, edge1, edge2;
};

// From the side, from near, off the edge, almost in the plane, tiny angles at corners.
const View kViews[] = {
    {{-0.5f, -0.5f, 1}, {1, 0, 0}, {0, 1, 0}},
    {{-0.5f, -0.5f, -0.1f}, {1, 0, 0}, {0, 1, 0}},
    {{0.2f, 0.3f, 0.2f}, {1, 0, 0}, {0, 1, 0}},
    {{-3, -0.5f, 0.4f}, {6, 0, 0}, {0, 1, 0}},
    {{0, 0.5f, 1}, {0, 0, 2}, {2, 0, 0}},
    {{-0.7f, 1, 0.3f}, {0, -2, 0}, {1, 0, 1}},
    {{-0.1f, -0.2f, 0.02f}, {0.3f, 0, 0}, {0, 5, 0}},
};

// Solid angle that a piece of the plane at corner + x edge1 + y edge2 fills, for each unit of x y.
double density(const View& v, double x, double y) {
  const Vec3d at = Vec3d(v.corner) + x * Vec3d(v.edge1) + y * Vec3d(v.edge2);
  const double distance = length(at);
  const Vec3d normal = cross(Vec3d(v.edge1), Vec3d(v.edge2));
  return std::fabs(dot(at, normal)) / (distance * distance * distance);
}

// Over the unit square of factors, or its half below x + y = 1 stretched over the square.
struct Stretched {
  bool is_triangle;
  double y_of(double x, double v) const { return is_triangle ? v * (1 - x) : v; }
  double v_of(double x, double y) const { return is_triangle ? y / std::fmax(1 - x, 1e-9) : y; }
  double density_at(const View& view, double x, double v) const {
    return density(view, x, y_of(x, v)) * (is_triangle ? 1 - x : 1);
  }
};

constexpr std::size_t kCells = 12, kSteps = 40;

// Of each cell, by the midpoint rule.
std::vector<double> expected_counts(const View& view, const Stretched& shape) {
  std::vector<double> cells(kCells * kCells);
  constexpr double kCount = kCells * kSteps;
  for (std::size_t j = 0; j < kCells * kSteps; ++j) {
    for (std::size_t i = 0; i < kCells * kSteps; ++i) {
      cells[j / kSteps * kCells + i / kSteps] +=
          shape.density_at(view, (double(i) + 0.5) / kCount, (double(j) + 0.5) / kCount) /
          (kCount * kCount);
    }
  }
  return cells;
}

template <class Seen>
void expect_uniform(const View& view, const Stretched& shape) {
  const Seen seen(view.corner, view.edge1, view.edge2);
  const std::vector<double> expected = expected_counts(view, shape);
  double whole = 0;
  for (const double cell : expected) whole += cell;
  ASSERT_GT(seen.solid_angle(), 0);
  EXPECT_NEAR(seen.solid_angle(), whole, 2e-3 * whole);
  Histogram found(kCells, kCells);
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 5);
    const Vec2f at = seen.sample({u[0], u[1]});
    ASSERT_TRUE(at.x >= 0 && at.y >= 0 && (shape.is_triangle ? at.x + at.y : at.x) <= 1.0001f);
    found.add(at.x, shape.v_of(at.x, at.y));
  }
  const ChiSquared fit = chi_squared_test(found.counts(), expected);
  EXPECT_GT(fit.p_value, corrected_significance(2 * std::size(kViews))) << fit;
}

TEST(SolidAngle, TrianglesAreSampledEvenly) {
  for (const View& view : kViews) expect_uniform<SeenTriangle>(view, {true});
}

TEST(SolidAngle, RectanglesAreSampledEvenly) {
  for (const View& view : kViews) expect_uniform<SeenRectangle>(view, {false});
}

TEST(SolidAngle, IsThatOfGeometry) {
  // An eighth of the sphere, and a rectangle before its middle [4 atan(ab / (d sqrt(..)))].
  const SeenTriangle octant({1, 0, 0}, {-1, 1, 0}, {-1, 0, 1});
  EXPECT_NEAR(octant.solid_angle(), kExactPi / 2, 1e-5);
  const SeenRectangle window({-2, -1, 3}, {4, 0, 0}, {0, 2, 0});
  EXPECT_NEAR(window.solid_angle(), 4 * std::atan(2 / (3 * std::sqrt(14.0))), 1e-5);
}

TEST(SolidAngle, WhatIsSmallOrFlatIsLeftToItsArea) {
  EXPECT_EQ(SeenTriangle({0, 0, 100}, {1, 0, 0}, {0, 1, 0}).solid_angle(), 0);
  EXPECT_EQ(SeenRectangle({0, 0, 100}, {1, 0, 0}, {0, 1, 0}).solid_angle(), 0);
  EXPECT_EQ(SeenTriangle({1, 1, 0}, {1, 0, 0}, {0, 1, 0}).solid_angle(), 0);
  EXPECT_EQ(SeenRectangle({1, 1, 0}, {1, 0, 0}, {0, 1, 0}).solid_angle(), 0);
  EXPECT_EQ(SeenTriangle({0, 0, 1}, {0, 0, 0}, {0, 0, 0}).solid_angle(), 0);
  EXPECT_EQ(SeenRectangle({0, 0, 1}, {0, 0, 0}, {0, 0, 0}).solid_angle(), 0);
}

// Light of a square that hangs right above a surface: its radiance times the cosine is all that
// varies, however near it is. By area the error would be several times the mean.
TEST(SolidAngle, NearEmittersHaveLittleNoise) {
  LitRoom room;
  room.scene.add_rectangle(ShapeKind::xy_rectangle, {-5, 5, -5, 5, 0.1}, room.add_glow({1, 1, 1}));
  const LitView lit(room.scene);
  double sum = 0, squares = 0;
  constexpr std::uint32_t kSamples = 10'000;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 9);
    const auto s = lit.lights.sample({0, 0, 0}, {0, 0, 1}, u[0], {u[1], u[2]});
    ASSERT_TRUE(s);
    const double value = double(s->radiance.x) * s->wi.z / s->pdf;
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kSamples, deviation = std::sqrt(squares / kSamples - mean * mean);
  EXPECT_NEAR(mean, kExactPi, 0.05);
  EXPECT_LT(deviation, 0.7 * mean);  // the cosine over the hemisphere has 1 / sqrt(3)
}

}  // namespace
}  // namespace dapple::test
