// Hits against the formulas in extended precision. Shapes have single-precision coordinates, so
// that only the arithmetic of the kernels is measured.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "accel/accel.h"

namespace dapple::test {
namespace {

using Exact = long double;
constexpr Exact kUnit = 0x1p-24L;  // relative rounding error of single precision
constexpr Exact kOperations = 16;  // roundings that one result accumulates, generously

class AnalyticHits : public ::testing::TestWithParam<AccelKind> {
 protected:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // Over many orders of magnitude.
  double magnitude(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  Vec3f point(double size) {
    return Vec3f(Vec3d(between(-size, size), between(-size, size), between(-size, size)));
  }

  std::mt19937_64 random_{7};
};

struct ExactSphereHit {
  Exact discriminant;        // of |o + t d - c|^2 = r^2, in units of length^2
  Exact discriminant_error;  // what single precision may be wrong by
  Exact first, second;       // roots, in units of length; meaningless if there are none
  Exact error(Exact root_free_error) const {
    const Exact root = std::sqrt(discriminant_error);
    if (discriminant <= 0) return root_free_error + root;
    return root_free_error + std::fmin(root, discriminant_error / std::sqrt(discriminant));
  }
};

// By the plain quadratic. Positions are wrong by kOperations roundings of the largest coordinate,
// which moves the squared distance from the centre by twice the radius times that.
ExactSphereHit exact_hit(const Ray& ray, const Vec3f& centre, float radius, Exact position_error) {
  const Vec3<Exact> o = Vec3<Exact>(ray.origin) - Vec3<Exact>(centre), d(ray.direction);
  const Exact a = dot(d, d), along = -dot(o, d) / a;
  const Vec3<Exact> nearest = o + along * d;
  const Exact r = std::fabs(Exact{radius});
  ExactSphereHit hit;
  hit.discriminant = r * r - dot(nearest, nearest);
  hit.discriminant_error = 2 * r * position_error + position_error * position_error;
  const Exact half = std::sqrt(std::fmax(0, hit.discriminant));
  hit.first = along * std::sqrt(a) - half;
  hit.second = along * std::sqrt(a) + half;
  return hit;
}

TEST_P(AnalyticHits, SpheresToWithinRounding) {
  std::size_t hits = 0, misses = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3f centre = point(magnitude(1e-2, 1e5));
    const auto radius = static_cast<float>(magnitude(1e-3, 1e5) * (i % 2 == 0 ? 1 : -1));
    Scene scene;
    scene.add_sphere({Vec3d(centre), radius}, scene.add_material(Lambertian{}));
    const auto accel = make_accel(GetParam(), scene);
    for (int k = 0; k < 400; ++k) {
      Ray ray;
      ray.origin = centre + point(std::fabs(radius) * magnitude(0.2, 1e3));
      const Vec3f target = centre + point(1.1 * std::fabs(radius));
      ray.direction = static_cast<float>(magnitude(1e-3, 1e3)) * (target - ray.origin);
      if (ray.direction == Vec3f{}) continue;  // the target was rounded to the origin
      const Exact position_error =
          kOperations * kUnit *
          (max_abs_component(Vec3<Exact>(ray.origin)) + max_abs_component(Vec3<Exact>(centre)) +
           std::fabs(Exact{radius}));
      const ExactSphereHit exact = exact_hit(ray, centre, radius, position_error);
      const Exact tolerance = exact.error(position_error);
      const Exact length_of_one = length(Vec3<Exact>(ray.direction));
      const Hit hit = accel->intersect(ray);
      hit.found() ? ++hits : ++misses;
      if (!hit.found()) {
        ASSERT_TRUE(exact.discriminant <= exact.discriminant_error || exact.second <= tolerance)
            << "missed at depth " << double(exact.discriminant);
        continue;
      }
      ASSERT_GE(exact.discriminant, -exact.discriminant_error) << "hit nothing";
      const Exact distance = Exact{hit.t} * length_of_one;
      const bool is_first = std::fabs(distance - exact.first) <= tolerance;
      const bool is_second = std::fabs(distance - exact.second) <= tolerance;
      ASSERT_TRUE(is_first || (is_second && exact.first <= tolerance))
          << "t " << double(distance) << ", exact " << double(exact.first) << " and "
          << double(exact.second) << ", tolerance " << double(tolerance);
    }
  }
  EXPECT_GT(hits, 50'000u);
  EXPECT_GT(misses, 10'000u);
}

TEST_P(AnalyticHits, RectanglesToWithinRounding) {
  std::size_t hits = 0, misses = 0;
  for (int i = 0; i < 300; ++i) {
    const ShapeKind kind = rectangle_kind(static_cast<std::size_t>(i) % 3);
    const RectangleAxes axes = rectangle_axes(kind);
    const double size = magnitude(1e-3, 1e5), offset = magnitude(1e-2, 1e5);
    const auto rounded = [&](double x) { return double{static_cast<float>(x)}; };
    Rectangle r;
    r.u0 = rounded(between(-offset, offset)), r.u1 = rounded(r.u0 + size);
    r.v0 = rounded(between(-offset, offset)), r.v1 = rounded(r.v0 + size);
    r.k = rounded(between(-offset, offset));
    Scene scene;
    scene.add_rectangle(kind, r, scene.add_material(Lambertian{}));
    const auto accel = make_accel(GetParam(), scene);
    for (int k = 0; k < 400; ++k) {
      Vec3d target, origin(point(10 * size));
      target[axes.u] = r.u0 + between(-0.3, 1.3) * size;
      target[axes.v] = r.v0 + between(-0.3, 1.3) * size;
      target[axes.k] = r.k;
      origin = origin + target;
      Ray ray;
      ray.origin = Vec3f(origin);
      ray.direction = Vec3f(magnitude(1e-3, 1e3) * (target - origin));
      if (ray.direction[axes.k] == 0 || ray.origin[axes.k] == float(r.k)) continue;
      const Vec3<Exact> o(ray.origin), d(ray.direction);
      const Exact t = (Exact(r.k) - o[axes.k]) / d[axes.k];
      // How far inside the nearest edge, and what single precision cannot tell apart.
      const Exact u = o[axes.u] + t * d[axes.u], v = o[axes.v] + t * d[axes.v];
      const Exact inside = std::fmin(std::fmin(u - Exact(r.u0), Exact(r.u1) - u),
                                     std::fmin(v - Exact(r.v0), Exact(r.v1) - v));
      const Exact tolerance =
          kOperations * kUnit * (max_abs_component(o) + std::fabs(t) * max_abs_component(d));
      const Hit hit = accel->intersect(ray);
      hit.found() ? ++hits : ++misses;
      if (hit.found()) {
        ASSERT_GE(inside, -tolerance);
        ASSERT_NEAR(double(hit.t / t), 1, double(4 * kUnit));  // three roundings
      } else {
        ASSERT_TRUE(inside <= tolerance || t < 0);
      }
    }
  }
  EXPECT_GT(hits, 30'000u);
  EXPECT_GT(misses, 30'000u);
}

// The end of a segment counts, what lies beyond does not.
TEST_P(AnalyticHits, SegmentsEndWhereTheyEnd) {
  Scene scene;
  const MaterialId material = scene.add_material(Lambertian{});
  scene.add_sphere({{0, 0, 5}, 1}, material);
  scene.add_rectangle(ShapeKind::xy_rectangle, {-1, 1, -1, 1, 8}, material);
  const auto accel = make_accel(GetParam(), scene);
  const auto hit = [&](float t_min, float t_max) {
    Ray ray;
    ray.direction = {0, 0, 1};
    ray.t_min = t_min;
    ray.t_max = t_max;
    EXPECT_EQ(accel->occluded(ray), accel->intersect(ray).found());
    return accel->intersect(ray);
  };
  EXPECT_EQ(hit(0, 100).t, 4.0f);
  EXPECT_EQ(hit(4, 4).t, 4.0f);
  EXPECT_EQ(hit(4.5f, 100).t, 6.0f);
  EXPECT_EQ(hit(6.5f, 100).t, 8.0f);
  EXPECT_EQ(hit(8, 8).prim, 1u);
  EXPECT_FALSE(hit(0, 3.9999f).found());
  EXPECT_FALSE(hit(4.5f, 5.5f).found());
  EXPECT_FALSE(hit(8.0001f, 1e30f).found());
  EXPECT_FALSE(hit(5, 4).found());
}

INSTANTIATE_TEST_SUITE_P(Kinds, AnalyticHits,
                         ::testing::Values(AccelKind::linear, AccelKind::median, AccelKind::fast),
                         [](const auto& kind) { return std::string(accel_name(kind.param)); });

}  // namespace
}  // namespace dapple::test
