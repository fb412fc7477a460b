#include "import/polygon.h"

#include <gtest/gtest.h>

#include "math/functions.h"

namespace dapple {
namespace {

Vec3d area_of(const std::vector<Vec3f>& polygon, const Corners& corners) {
  const Vec3d a(polygon[corners[0]]), b(polygon[corners[1]]), c(polygon[corners[2]]);
  return 0.5 * cross(b - a, c - a);
}

// Turned into a plane that lies along no axis.
Vec3f tilted(double x, double y) {
  return Vec3f(Vec3d(0.36 * x - 0.8 * y, 0.48 * x + 0.6 * y, 0.8 * x));
}

// A star with arms of two lengths: every other corner turns the other way.
std::vector<Vec3f> star(int arms, double inner) {
  std::vector<Vec3f> polygon;
  for (int i = 0; i < 2 * arms; ++i) {
    const auto [s, c] = sin_cos_turns(i / (2.0 * arms));
    const double radius = i % 2 == 0 ? 1 : inner;
    polygon.push_back(tilted(radius * c, radius * s));
  }
  return polygon;
}

// All triangles turn like the polygon, and their areas add up to its own: they tile it.
void expect_tiled(const std::vector<Vec3f>& polygon, double area) {
  std::vector<Corners> triangles;
  triangulate(polygon, triangles);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  const Vec3d normal = normalize(cross(Vec3d(tilted(1, 0)), Vec3d(tilted(0, 1))));
  double sum = 0;
  for (const Corners& corners : triangles) {
    EXPECT_GE(dot(area_of(polygon, corners), normal), -1e-6);
    sum += length(area_of(polygon, corners));
  }
  EXPECT_NEAR(sum, area, 1e-6 * area);
}

TEST(Polygon, ConvexAndConcaveOnesAreTiled) {
  for (int arms = 3; arms < 40; ++arms) {
    for (const double inner : {0.1, 0.5, 0.999}) {
      // 2 arms n triangles between two neighbouring corners and the centre.
      const double area = arms * inner * sin_cos_turns(1 / (2.0 * arms)).sin;
      expect_tiled(star(arms, inner), area);
    }
  }
}

TEST(Polygon, ACombIsTiled) {
  std::vector<Vec3f> comb = {tilted(0, -1), tilted(10, -1)};
  for (int tooth = 10; tooth > 0; --tooth) {
    comb.push_back(tilted(tooth, 0));
    comb.push_back(tilted(tooth - 0.5, 5));
  }
  comb.push_back(tilted(0, 0));
  expect_tiled(comb, 10 + 10 * 0.5 * 5);
}

TEST(Polygon, DamagedOnesAreCutIntoAsManyTriangles) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::vector<Vec3f>> damaged = {
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},      // crosses itself
      {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},      // one point
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},      // a line
      {{0, 0, 0}, {1, nan, 0}, {2, 0, 0}, {3, 0, nan}},  // not finite
      {{1e38f, 0, 0}, {-1e38f, 1e38f, 0}, {0, -1e38f, 1e38f}, {0, 0, 1e38f}},
  };
  for (const auto& polygon : damaged) {
    std::vector<Corners> triangles;
    triangulate(polygon, triangles);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    for (const Corners& corners : triangles) {
      for (const std::uint32_t corner : corners) EXPECT_LT(corner, polygon.size());
    }
  }
}

TEST(Polygon, FewerThanThreeCornersGiveNothing) {
  std::vector<Corners> triangles;
  triangulate(std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}}, triangles);
  EXPECT_TRUE(triangles.empty());
}

}  // namespace
}  // namespace dapple
