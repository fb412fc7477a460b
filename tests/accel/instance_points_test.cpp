// The places that hits denote on cylinders, and on triangles seen through instances.
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

class PlacedPoints : public ::testing::Test {
 protected:
  float uniform() { return static_cast<float>(random_() >> 40) * 0x1p-24f; }
  Vec3f direction() {
    const float u = uniform();
    return sample_uniform_sphere(u, uniform());
  }
  Ray ray_to(const Vec3f& target, float distance) {
    Ray ray;
    ray.origin = target + distance * direction();
    ray.direction = target - ray.origin;
    return ray;
  }
  float between(float low, float high) { return low + (high - low) * uniform(); }

  std::mt19937_64 random_{9};
};

Scene one_cylinder(const Vec3f& begin, const Vec3f& end, float radius) {
  Scene scene;
  scene.add_cylinder({Vec3d(begin), Vec3d(end), radius}, scene.add_material(Lambertian{}));
  return scene;
}

TEST_F(PlacedPoints, OnCylindersTheyLieOnTheSideOrAnEnd) {
  for (int trial = 0; trial < 40; ++trial) {
    const float size = std::ldexp(1.0f, trial % 20 - 10), radius = size * between(0.01f, 1);
    const Vec3f begin = (trial % 3) * size * direction();
    const Vec3f end = begin + size * direction();
    const auto accel = make_accel(AccelKind::fast, one_cylinder(begin, end, radius));
    const Vec3x axis = (Vec3x(end) - Vec3x(begin)) / length(Vec3x(end) - Vec3x(begin));
    const Exact whole = length(Vec3x(end) - Vec3x(begin));
    std::size_t sides = 0, ends = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec3f target = begin + uniform() * (end - begin) + (0.6f * radius) * direction();
      const Ray ray = ray_to(target, 3 * size);
      const Hit hit = accel->intersect(ray);
      if (!hit.found()) continue;
      const SurfacePoint point = accel->locate(ray, hit);
      const Vec3x from = Vec3x(point.position) - Vec3x(begin);
      const Exact along = dot(from, axis), off_axis = length(from - along * axis);
      const bool on_side = std::fabs(dot(Vec3x(point.outward), axis)) < 0.5L;
      (on_side ? sides : ends) += 1;
      const Exact off = on_side             ? off_axis - Exact{radius}
                        : along < whole / 2 ? along
                                            : along - whole;
      ASSERT_LE(std::fabs(off), Exact{point.error});
      ASSERT_LE(off_axis, Exact{radius} + Exact{point.error});
      ASSERT_GE(along, -Exact{point.error});
      ASSERT_LE(along, whole + Exact{point.error});
      ASSERT_NEAR(length(point.outward), 1, 4e-7);
      const Exact out = on_side ? dot(Vec3x(point.outward), from - along * axis)
                                : dot(Vec3x(point.outward), axis) * (along - whole / 2);
      ASSERT_GT(out, 0);
      // From outside, a ray meets the face that looks at it.
      ASSERT_LT(dot(point.outward, ray.direction), 0);
    }
    EXPECT_GT(sides, 0u);
    EXPECT_GT(sides + ends, 100u);
  }
}

TEST_F(PlacedPoints, ACylinderIsMetWhereTheFormulaSays) {
  const auto accel = make_accel(AccelKind::fast, one_cylinder({0, 0, -1}, {0, 0, 2}, 0.5f));
  const auto t_of = [&](const Vec3f& origin, const Vec3f& to) {
    Ray ray;
    ray.origin = origin;
    ray.direction = to;
    return accel->intersect(ray).t;
  };
  EXPECT_FLOAT_EQ(t_of({-3, 0, 0}, {1, 0, 0}), 2.5f);     // the side
  EXPECT_FLOAT_EQ(t_of({0.2f, 0.1f, 9}, {0, 0, -1}), 7);  // an end
  EXPECT_FLOAT_EQ(t_of({0, 0, 0}, {1, 0, 0}), 0.5f);      // from within
  EXPECT_FLOAT_EQ(t_of({0, 0, 0}, {0, 0, -2}), 0.5f);
  EXPECT_EQ(t_of({-3, 0.6f, 0}, {1, 0, 0}), Hit{}.t);
  EXPECT_EQ(t_of({-3, 0, 2.1f}, {1, 0, 0}), Hit{}.t);
  EXPECT_EQ(t_of({0.6f, 0, 9}, {0, 0, -1}), Hit{}.t);
}

// A prototype seen through a map, against the same triangles moved by it.
TEST_F(PlacedPoints, AnInstanceIsThePrototypeMoved) {
  for (int trial = 0; trial < 30; ++trial) {
    Scene scene;
    const MaterialId material = scene.add_material(Lambertian{});
    Scene mesh;
    add_cube_mesh({{0.5f, 0, -1}, 1, 6, 1, 0.2f}, material, mesh);
    scene.vertices = mesh.vertices;
    Instance instance;
    instance.prototype = scene.add_prototype(mesh.triangles, mesh.triangle_materials);
    for (auto& row : instance.to_world.rows) {
      for (float& number : row) number = between(-1, 1);
      row[3] = between(-100, 100);
    }
    if (std::fabs(determinant(instance.to_world)) < 0.05f) continue;
    scene.add_instance(instance);
    Scene moved = mesh;
    for (Vec3f& p : moved.vertices.positions) p = Vec3f(instance.to_world.point(Vec3d(p)));
    const auto accel = make_accel(AccelKind::fast, scene);
    const auto expected = make_accel(AccelKind::fast, moved);
    std::size_t same = 0, found = 0;
    for (int i = 0; i < 1000; ++i) {
      const Ray ray = ray_to(instance.to_world.point(1.2f * direction()), 5);
      const Hit hit = accel->intersect(ray), other = expected->intersect(ray);
      if (!other.found()) continue;
      ++found;
      if (!hit.found() || hit.prim != other.prim) continue;  // by an edge or a silhouette
      ++same;
      ASSERT_EQ(hit.lane.instance_index(), 0u);
      const SurfacePoint at = accel->locate(ray, hit), there = expected->locate(ray, other);
      ASSERT_NEAR(hit.t, other.t, 1e-3f * other.t);
      const float across = std::fabs(dot(normalize(ray.direction), there.outward));
      ASSERT_LE(length(at.position - there.position), (at.error + there.error) * 40 / across);
      const float side = determinant(instance.to_world) < 0 ? -1.0f : 1.0f;
      ASSERT_GE(side * dot(at.outward, there.outward), 0.999f);
      // Exactly in the plane of the exactly moved triangle.
      const auto corner = [&](std::size_t k) {
        const Vec3f& p = scene.vertices.positions[scene.triangles[hit.prim].vertices[k]];
        Vec3x q;
        for (int axis = 0; axis < 3; ++axis) {
          const auto& row = instance.to_world.rows[axis];
          q[axis] = Exact{row[0]} * p.x + Exact{row[1]} * p.y + Exact{row[2]} * p.z + row[3];
        }
        return q;
      };
      const Vec3x normal = cross(corner(1) - corner(0), corner(2) - corner(0));
      const Exact off = dot(Vec3x(at.position) - corner(0), normal) / length(normal);
      ASSERT_LE(std::fabs(off), Exact{at.error});
      ASSERT_EQ(accel->occluded(ray), true);
    }
    ASSERT_GT(found, 200u);
    EXPECT_GT(same, found * 98 / 100);
  }
}

// The copies share their triangles: memory grows by what an instance needs.
TEST(Instances, CostMemoryForThemselvesOnly) {
  const auto bytes_with = [](int instances) {
    Scene scene, mesh;
    const MaterialId material = scene.add_material(Lambertian{});
    add_cube_mesh({{0, 0, 0}, 1, 10, 1, 0}, material, mesh);
    scene.vertices = mesh.vertices;
    Instance instance;
    instance.prototype = scene.add_prototype(mesh.triangles, mesh.triangle_materials);
    for (int i = 0; i < instances; ++i) {
      instance.to_world.rows[0][3] = static_cast<float>(3 * (i % 50));
      instance.to_world.rows[1][3] = static_cast<float>(3 * (i / 50));
      scene.add_instance(instance);
    }
    return make_accel(AccelKind::fast, scene)->stats().bytes;
  };
  EXPECT_LT(bytes_with(2500) - bytes_with(500), std::size_t{2000} * 160);
}

// A map without an inverse, which scenes do not have when they are validated.
TEST(Instances, ThoseWithoutAnInverseShowNothing) {
  Scene scene, mesh;
  const MaterialId material = scene.add_material(Lambertian{});
  add_cube_mesh({{0, 0, 0}, 1, 2, 0, 0}, material, mesh);
  scene.vertices = mesh.vertices;
  Instance flat;
  flat.prototype = scene.add_prototype(mesh.triangles, mesh.triangle_materials);
  for (float& number : flat.to_world.rows[1]) number = 0;
  scene.add_instance(flat);
  Ray ray;
  ray.origin = {0, 5, 0};
  ray.direction = {0, -1, 0};
  for (const AccelKind kind : {AccelKind::linear, AccelKind::median, AccelKind::fast}) {
    EXPECT_FALSE(make_accel(kind, scene)->intersect(ray).found());
    EXPECT_FALSE(make_accel(kind, scene)->occluded(ray));
  }
}

// Equal distances: what stands in the world first, then instances by their order.
TEST(Instances, TiesGoToTheWorldAndThenToTheFirst) {
  Scene scene;
  const MaterialId material = scene.add_material(Lambertian{});
  scene.vertices.positions = {{-1, -1, 5}, {1, -1, 5}, {0, 1, 5}};
  const Triangle triangle{{0, 1, 2}};
  for (const bool in_world : {false, true}) {
    Scene copy = scene;
    if (in_world) copy.add_triangle(triangle, material);
    const Triangle twice[] = {triangle, triangle};
    const MaterialId materials[] = {material, material};
    Instance instance;
    instance.prototype = copy.add_prototype(twice, materials);
    for (int i = 0; i < 40; ++i) copy.add_instance(instance);
    for (const AccelKind kind : {AccelKind::linear, AccelKind::median, AccelKind::fast}) {
      const auto accel = make_accel(kind, copy);
      Ray ray;
      ray.direction = {0, 0, 1};
      const Hit hit = accel->intersect(ray);
      EXPECT_EQ(hit.t, 5);
      EXPECT_EQ(hit.prim, 0u);
      EXPECT_EQ(hit.lane.seen_through(), in_world ? 0u : 1u) << accel_name(kind);
    }
  }
}

}  // namespace
}  // namespace dapple::test
