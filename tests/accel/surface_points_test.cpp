// The places that hits denote: on the surface to within their error bound, with a unit normal
// that points outwards, and good to start the next ray from.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "accel/accel.h"
#include "math/warps.h"

namespace dapple::test {
namespace {

using Exact = long double;

class SurfacePoints : public ::testing::Test {
 protected:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  float uniform() { return static_cast<float>(random_() >> 40) * 0x1p-24f; }
  Vec3f direction() {
    const float u = uniform();
    return sample_uniform_sphere(u, uniform());
  }
  // Towards a random point of the ball, from `distance` radii away.
  Ray ray_to_ball(const Vec3f& centre, float radius, float distance) {
    Ray ray;
    ray.origin = centre + (distance * radius) * direction();
    ray.direction = normalize(centre + (0.99f * radius * uniform()) * direction() - ray.origin);
    return ray;
  }

  std::mt19937_64 random_{11};
};

struct Ball {
  float offset, radius;
};
// From small ones near to small ones far away, where the radius is a few steps of the coordinates.
constexpr Ball kBalls[] = {{0, 1e-3f},   {0, 1},       {0, 1e6f}, {1, 1e-3f}, {10, 0.1f},
                           {100, 1},     {1e3f, 0.1f}, {1e4f, 1}, {1e6f, 2},  {1e6f, 100},
                           {1e6f, 1e6f}, {300, 6},     {-3e4f, 3}};

Scene one_ball(const Vec3f& centre, float radius) {
  Scene scene;
  scene.add_sphere({Vec3d(centre), radius}, scene.add_material(Lambertian{}));
  return scene;
}

TEST_F(SurfacePoints, OnSpheresTheyLieWithinTheErrorAndNormalsPointOut) {
  for (const Ball& ball : kBalls) {
    for (const float sign : {1.0f, -1.0f}) {
      const Vec3f centre = ball.offset * Vec3f(1, -0.7f, 0.4f);
      const auto accel = make_accel(AccelKind::fast, one_ball(centre, sign * ball.radius));
      for (int i = 0; i < 2000; ++i) {
        const Ray ray = ray_to_ball(centre, ball.radius, i % 2 == 0 ? 3.0f : 0.5f);
        const Hit hit = accel->intersect(ray);
        if (!hit.found()) continue;
        const SurfacePoint point = accel->locate(ray, hit);
        const Vec3<Exact> radial = Vec3<Exact>(point.position) - Vec3<Exact>(centre);
        const Exact off = std::fabs(length(radial) - Exact{ball.radius});
        ASSERT_LE(off, Exact{point.error}) << ball.offset << " " << ball.radius;
        ASSERT_NEAR(length(point.outward), 1, 4e-7);
        // The position is rounded to the error bound, the normal is not.
        const Exact towards = dot(Vec3<Exact>(sign * point.outward), radial) / ball.radius;
        ASSERT_GE(towards, 1 - 2 * Exact{point.error} / ball.radius - 1e-6L);
        // Where the ray is, up to the error of its root, which grows as it grazes the surface.
        const Exact grazing =
            std::fabs(dot(Vec3<Exact>(ray.direction), radial)) / Exact{ball.radius};
        const Vec3<Exact> on_ray =
            Vec3<Exact>(ray.origin) + Exact{hit.t} * Vec3<Exact>(ray.direction);
        ASSERT_LE(length(on_ray - Vec3<Exact>(point.position)),
                  16 * Exact{point.error} / std::fmax(grazing, 1e-3L));
      }
    }
  }
}

TEST_F(SurfacePoints, OnRectanglesTheyLieInThePlane) {
  for (std::size_t k = 0; k < kRectangleKindCount; ++k) {
    const ShapeKind kind = rectangle_kind(k);
    const RectangleAxes axes = rectangle_axes(kind);
    Scene scene;
    scene.add_rectangle(kind, {-3, 5, 2, 9, 1234.5f}, scene.add_material(Lambertian{}));
    const auto accel = make_accel(AccelKind::fast, scene);
    for (int i = 0; i < 5000; ++i) {
      Vec3f target;
      target[axes.u] = static_cast<float>(between(-3, 5));
      target[axes.v] = static_cast<float>(between(2, 9));
      target[axes.k] = 1234.5f;
      Ray ray;
      ray.origin = target + 10.0f * direction();
      ray.direction = target - ray.origin;
      const Hit hit = accel->intersect(ray);
      if (!hit.found()) continue;
      const SurfacePoint point = accel->locate(ray, hit);
      ASSERT_EQ(point.position[axes.k], 1234.5f);
      ASSERT_LE(length(point.position - target),
                16 * point.error / std::fabs(normalize(ray.direction)[axes.k]));
      Vec3f normal;
      normal[axes.k] = 1;
      ASSERT_EQ(point.outward, normal);
    }
  }
}

// As paths do: from a surface point moved off by its error, in any direction of the half space on
// that side, a ray does not meet the convex body that it leaves. `near_tangent` directions are
// within a thousandth of the tangent plane.
TEST_F(SurfacePoints, RaysThatLeaveAConvexBodyDoNotMeetItAgain) {
  for (const Ball& ball : kBalls) {
    const Vec3f centre = ball.offset * Vec3f(0.3f, 1, -0.5f);
    const auto accel = make_accel(AccelKind::fast, one_ball(centre, ball.radius));
    for (int i = 0; i < 4000; ++i) {
      const Ray ray = ray_to_ball(centre, ball.radius, 3.0f);
      const Hit hit = accel->intersect(ray);
      if (!hit.found()) continue;
      const SurfacePoint point = accel->locate(ray, hit);
      const Vec3f normal = point.outward;
      Vec3f out = direction();
      const float height = dot(out, normal);
      if (height < 0) out = out - 2 * height * normal;
      const bool near_tangent = i % 4 == 0;
      if (near_tangent) out = normalize(out + (0.001f * uniform() - dot(out, normal)) * normal);
      if (dot(out, normal) < 0) continue;
      Ray leaving;
      leaving.origin = point.position + point.error * normal;
      leaving.direction = out;
      leaving.t_min = 1e-3f;
      ASSERT_FALSE(accel->intersect(leaving).found())
          << "offset " << ball.offset << ", radius " << ball.radius << ", hit " << i << " t "
          << accel->intersect(leaving).t << ", height " << dot(out, normal);
    }
  }
}

// And one that goes in comes out on the other side, whatever the angle.
TEST_F(SurfacePoints, RaysThatEnterABallLeaveItOnTheOtherSide) {
  for (const Ball& ball : kBalls) {
    const Vec3f centre = ball.offset * Vec3f(0.3f, 1, -0.5f);
    const auto accel = make_accel(AccelKind::fast, one_ball(centre, ball.radius));
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = ray_to_ball(centre, ball.radius, 3.0f);
      const Hit hit = accel->intersect(ray);
      if (!hit.found()) continue;
      const SurfacePoint point = accel->locate(ray, hit);
      Vec3f in = direction();
      const float height = dot(in, point.outward);
      if (height > 0) in = in - 2 * height * point.outward;
      const float chord = 2 * ball.radius * std::fabs(height);
      if (std::fabs(height) < 0.05f || chord < 0.01f || chord < 100 * point.error) continue;
      Ray inside;
      inside.origin = point.position - point.error * point.outward;
      inside.direction = in;
      inside.t_min = 1e-3f;
      const Hit exit = accel->intersect(inside);
      ASSERT_TRUE(exit.found());
      ASSERT_NEAR(exit.t, chord, 1e-3f * chord + 64 * point.error / std::fabs(height));
    }
  }
}

// A ball smaller than the step of single-precision coordinates around it is still hit by rays
// from there; what is found must at least be usable.
TEST_F(SurfacePoints, NormalsStayUnitWhenTheBallVanishesBesideItsCoordinates) {
  const Vec3f centre(1e6f, -1e6f, 3e5f);
  for (const float radius : {1e-3f, 1e-6f, 1e-12f, 1e-18f}) {
    const auto accel = make_accel(AccelKind::fast, one_ball(centre, radius));
    std::size_t hits = 0;
    for (int i = 0; i < 2000; ++i) {
      Ray ray;
      ray.direction = direction();
      ray.origin = centre - std::ldexp(1.0f, i % 20) * ray.direction;
      if (i % 3 == 0) {
        ray.direction = Vec3f(i % 2 == 0 ? 1 : 0, i % 2, 0);
        ray.origin = centre - 100.0f * ray.direction;
      }
      const Hit hit = accel->intersect(ray);
      if (!hit.found()) continue;
      ++hits;
      const SurfacePoint point = accel->locate(ray, hit);
      ASSERT_NEAR(length(point.outward), 1, 4e-7) << "radius " << radius;
      ASSERT_TRUE(is_finite(point.position));
    }
    EXPECT_GT(hits, 0u);
  }
}

}  // namespace
}  // namespace dapple::test
