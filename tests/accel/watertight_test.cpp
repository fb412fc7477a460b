// No ray slips through a closed mesh, not even where triangles meet.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "accel/accel.h"
#include "accel/kernels/dispatch.h"
#include "tests/scenes/meshes.h"

namespace dapple::test {
namespace {

constexpr CubeMesh kMeshes[] = {
    {{0, 0, 0}, 1, 1, 0, 0},               // twelve triangles along the axes
    {{3, -5, 7}, 2, 7, 0, 0},              // coplanar ones
    {{0, 0, 0}, 1, 16, 1, 0},              //
    {{0.5f, 0.25f, -3}, 10, 24, 1, 0.3f},  // bumps
    {{1000, 2000, -500}, 1, 12, 1, 0.2f},  // few digits left
    {{0, 0, 0}, 1e-5f, 12, 0.5f, 0.1f},    //
    {{0, 0, 0}, 1e6f, 40, 0.8f, 0.02f},    //
};

class Watertight : public ::testing::TestWithParam<CubeMesh> {
 protected:
  void SetUp() override { add_cube_mesh(GetParam(), scene_.add_material(Lambertian{}), scene_); }

  std::size_t pick(std::size_t count) { return random_() % count; }
  float uniform() { return static_cast<float>(random_() >> 40) * 0x1p-24f; }

  Vec3f vertex(const Triangle& t, std::size_t i) const {
    return scene_.vertices.positions[t.vertices[i]];
  }

  // Near the centre: the mesh is seen whole from there.
  Vec3f inside() {
    const CubeMesh& mesh = GetParam();
    const float around = 0.3f * mesh.size;
    return mesh.centre + around * Vec3f(uniform() - 0.5f, uniform() - 0.5f, uniform() - 0.5f);
  }

  // At a vertex, on an edge, or as near to one as single precision allows.
  Vec3f on_edge() {
    const Triangle& t = scene_.triangles[pick(scene_.triangles.size())];
    const std::size_t i = pick(3);
    const Vec3f a = vertex(t, i), b = vertex(t, (i + 1) % 3);
    if (pick(3) == 0) return a;
    Vec3f at = a + uniform() * (b - a);
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t nudge = pick(4);
      if (nudge < 2) at[axis] = std::nextafterf(at[axis], nudge == 0 ? -1e30f : 1e30f);
    }
    return at;
  }

  std::vector<Ray> rays(std::size_t count) {
    std::vector<Ray> result(count);
    for (std::size_t i = 0; i < count; ++i) {
      Ray& ray = result[i];
      // In runs that share an origin and nearly a direction, which packets are made of.
      const bool follows = i % 256 >= 128 && i % 128 != 0;
      ray.origin = follows ? result[i - 1].origin : inside();
      const Vec3f target = follows ? result[i - 1].at(1.0f) : on_edge();
      ray.direction = target - ray.origin;
      if (follows) ray.direction = 1.0001f * ray.direction;
    }
    return result;
  }

  Scene scene_;
  std::mt19937_64 random_{7};
};

TEST_P(Watertight, NoRayFromInsideEscapes) {
  constexpr std::size_t kRays = 300'000;
  const auto accel = make_accel(AccelKind::fast, scene_);
  const std::vector<Ray> all = rays(kRays);
  std::vector<Hit> hits(kRays);
  std::vector<std::uint8_t> occluded(kRays);
  for (const std::string_view isa : available_isas()) {
    ASSERT_TRUE(force_isa(isa));
    accel->intersect(all, hits);
    accel->occluded(all, occluded);
    std::size_t misses = 0;
    for (std::size_t i = 0; i < kRays; ++i) misses += !hits[i].found() || occluded[i] == 0;
    EXPECT_EQ(misses, 0u) << isa;
  }
  ASSERT_TRUE(force_isa(available_isas().front()));
}

// The median tree tests one triangle at a time, with the same rounding of boxes.
TEST_P(Watertight, NorThroughTheTextbookTree) {
  constexpr std::size_t kRays = 20'000;
  const auto accel = make_accel(AccelKind::median, scene_);
  const std::vector<Ray> all = rays(kRays);
  std::vector<Hit> hits(kRays);
  accel->intersect(all, hits);
  for (std::size_t i = 0; i < kRays; ++i) ASSERT_TRUE(hits[i].found()) << "ray " << i;
}

INSTANTIATE_TEST_SUITE_P(Meshes, Watertight, ::testing::ValuesIn(kMeshes));

}  // namespace
}  // namespace dapple::test
