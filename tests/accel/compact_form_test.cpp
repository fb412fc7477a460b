// The compact form is the same tree in less memory: what it finds, and where, is the same to the
// bit (agreement_test.cpp has the hits).
#include <gtest/gtest.h>

#include <cstring>

#include "accel/accel.h"
#include "accel/wide_builder.h"
#include "scene/scene_view.h"
#include "tests/scenes/meshes.h"
#include "tests/scenes/nasty_scenes.h"

namespace dapple::test {
namespace {

std::unique_ptr<Accel> fast_accel(const SceneView& scene, LeafForm form) {
  return make_accel(AccelKind::fast, scene, BvhQuality::medium, form);
}

WideBvh build(const SceneView& scene, LeafForm form) {
  return build_wide_bvh(scene, nullptr, BvhQuality::medium, form);
}

double bytes_per_triangle(const SceneView& scene, LeafForm form) {
  return double(fast_accel(scene, form)->stats().bytes) / double(scene.triangles.size());
}

Scene bumpy_mesh() {
  Scene scene;
  add_cube_mesh({{0, 0, 0}, 1, 40, 1, 0.3f}, scene.add_material(Lambertian{}), scene);
  return scene;
}

// No two triangles share a vertex.
Scene apart(const Scene& mesh) {
  Scene scene = mesh;
  scene.vertices.positions.clear();
  for (Triangle& triangle : scene.triangles) {
    for (std::uint32_t& vertex : triangle.vertices) {
      scene.vertices.positions.push_back(mesh.vertices.positions[vertex]);
      vertex = static_cast<std::uint32_t>(scene.vertices.positions.size() - 1);
    }
  }
  return scene;
}

TEST(CompactForm, TakesAtMost36BytesATriangle) {
  const Scene mesh = bumpy_mesh();
  NastyConfig config;
  config.shapes = Shapes::triangles;
  config.object_count = 20'000;
  config.size = 100;
  for (const Scene& scene : {mesh, apart(mesh), nasty_scene(config, 1)}) {
    EXPECT_LE(bytes_per_triangle(scene, LeafForm::compact), 36);
    EXPECT_LE(bytes_per_triangle(scene, LeafForm::whole), 60);
  }
}

TEST(CompactForm, OfAPrototypeTakesAtMost36BytesATriangle) {
  Scene scene = bumpy_mesh();
  scene.prototypes.push_back({0, static_cast<std::uint32_t>(scene.triangles.size())});
  scene.instances.emplace_back();
  scene.runs = {{ShapeKind::instance, 1}};
  EXPECT_LE(bytes_per_triangle(scene, LeafForm::compact), 36);
}

// Same boxes, same children, same ids in every leaf; only rows differ.
TEST(CompactForm, IsTheSameTree) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = nasty_scene(nasty_config(seed), seed);
    const WideBvh whole = build(scene, LeafForm::whole), compact = build(scene, LeafForm::compact);
    ASSERT_EQ(whole.nodes.size(), compact.nodes.size());
    for (std::size_t n = 0; n < whole.nodes.size(); ++n) {
      const WideNode &a = whole.nodes[n], &b = compact.nodes[n];
      ASSERT_EQ(std::memcmp(&a, &b, offsetof(WideNode, children)), 0) << "seed " << seed;
      for (std::size_t i = 0; i < kWideWidth; ++i) {
        const ChildRef x = a.children[i], y = b.children[i];
        if (!x.is_leaf()) {
          ASSERT_EQ(x.bits, y.bits);
          continue;
        }
        ASSERT_TRUE(y.is_leaf());
        ASSERT_EQ(x.leaf_kind(), y.leaf_kind());
        const std::size_t of_whole = x.leaf_row() + leaf_id_row(x.leaf_kind());
        const std::size_t of_compact = y.leaf_row() + leaf_id_row(y.leaf_kind(), LeafForm::compact);
        ASSERT_EQ(std::memcmp(&whole.rows[of_whole], &compact.rows[of_compact], sizeof(LeafRow)),
                  0);
      }
    }
  }
}

TEST(CompactForm, LocatesHitsAlike) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const NastyConfig config = nasty_config(seed);
    const Scene scene = nasty_scene(config, seed);
    const auto rays = nasty_rays(scene, config, 500, seed);
    const auto whole = fast_accel(scene, LeafForm::whole);
    const auto compact = fast_accel(scene, LeafForm::compact);
    for (const Ray& ray : rays) {
      const Hit hit = whole->intersect(ray);
      if (!hit.found()) continue;
      ++found;
      const SurfacePoint expected = whole->locate(ray, hit);
      const SurfacePoint actual = compact->locate(ray, compact->intersect(ray));
      ASSERT_EQ(std::memcmp(&actual, &expected, sizeof(SurfacePoint)), 0) << "seed " << seed;
    }
  }
  EXPECT_GT(found, 1000u);
}

}  // namespace
}  // namespace dapple::test
