// The places that hits on triangles denote.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "accel/accel.h"
#include "math/warps.h"
#include "tests/scenes/meshes.h"

namespace dapple::test {
namespace {

using Exact = long double;
using Vec3x = Vec3<Exact>;

constexpr CubeMesh kMeshes[] = {
    {{0, 0, 0}, 1, 6, 1, 0},    {{0, 0, 0}, 1e3f, 20, 1, 0},  {{10, -7, 3}, 1, 1, 0, 0},
    {{300, 1, 0}, 1, 10, 1, 0}, {{0, 0, 0}, 1e-3f, 10, 1, 0}, {{1e4f, -1e4f, 0}, 5, 8, 1, 0},
};

class TrianglePoints : public ::testing::TestWithParam<CubeMesh> {
 protected:
  TrianglePoints() { add_cube_mesh(GetParam(), scene_.add_material(Lambertian{}), scene_); }

  float uniform() { return static_cast<float>(random_() >> 40) * 0x1p-24f; }
  Vec3f direction() {
    const float u = uniform();
    return sample_uniform_sphere(u, uniform());
  }
  Ray ray() {
    const CubeMesh& mesh = GetParam();
    Ray ray;
    ray.origin = mesh.centre + (uniform() < 0.5f ? 0.2f : 4.0f) * mesh.size * direction();
    ray.direction = normalize(mesh.centre + 0.7f * mesh.size * direction() - ray.origin);
    return ray;
  }
  std::array<Vec3x, 3> corners(const Hit& hit) const {
    std::array<Vec3x, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = scene_.triangles[hit.prim].vertices[i];
      result[i] = Vec3x(scene_.vertices.positions[vertex]);
    }
    return result;
  }

  Scene scene_;
  std::mt19937_64 random_{5};
};

TEST_P(TrianglePoints, LieInThePlaneWithTheWeightsOfTheVertices) {
  const auto accel = make_accel(AccelKind::fast, scene_);
  std::size_t found = 0;
  for (int i = 0; i < 5000; ++i) {
    const Ray r = ray();
    const Hit hit = accel->intersect(r);
    if (!hit.found()) continue;
    ++found;
    const SurfacePoint point = accel->locate(r, hit);
    const auto [a, b, c] = corners(hit);
    const Vec3x cross_product = cross(b - a, c - a);
    const Vec3x normal = cross_product / length(cross_product);
    ASSERT_LE(std::fabs(dot(Vec3x(point.position) - a, normal)), Exact{point.error});
    // Subtracting the corners' coordinates keeps what digits they have.
    ASSERT_GE(dot(normal, Vec3x(point.outward)), 1 - 1e-6L);
    ASSERT_NEAR(length(point.outward), 1, 4e-7);
    const Vec3x weighed =
        (1 - Exact{point.u} - Exact{point.v}) * a + Exact{point.u} * b + Exact{point.v} * c;
    ASSERT_LE(length(Vec3x(point.position) - weighed), Exact{point.error});
    ASSERT_GE(point.u, 0);
    ASSERT_GE(point.v, 0);
    ASSERT_LE(point.u + point.v, 1 + 1e-6f);
    const Vec3x on_ray = Vec3x(r.origin) + Exact{hit.t} * Vec3x(r.direction);
    const Exact grazing = std::fabs(dot(Vec3x(r.direction), normal));
    ASSERT_LE(length(on_ray - Vec3x(point.position)),
              16 * (Exact{point.error} + 0x1p-22L * Exact{hit.t}) / std::fmax(grazing, 1e-3L));
  }
  EXPECT_GT(found, 1000u);
}

// A path that leaves a convex body from its outside does not meet it again, even without a smallest
// distance; nor does one that goes in find the triangle that it came through.
TEST_P(TrianglePoints, RaysThatLeaveDoNotMeetTheirTriangleAgain) {
  const auto accel = make_accel(AccelKind::fast, scene_);
  for (int i = 0; i < 20'000; ++i) {
    const Ray r = ray();
    const Hit hit = accel->intersect(r);
    if (!hit.found()) continue;
    const SurfacePoint point = accel->locate(r, hit);
    Vec3f out = direction();
    const float height = dot(out, point.outward);
    const float side = height < 0 ? -1.0f : 1.0f;
    if (i % 4 == 0) out = normalize(out + (side * 0.001f * uniform() - height) * point.outward);
    if (dot(out, point.outward) * side <= 0) continue;
    Ray leaving;
    leaving.origin = point.position + (side * point.error) * point.outward;
    leaving.direction = out;
    ASSERT_NE(accel->intersect(leaving).prim, hit.prim)
        << "ray " << i << ", height " << dot(out, point.outward);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, TrianglePoints, ::testing::ValuesIn(kMeshes));

}  // namespace
}  // namespace dapple::test
