// Trees that hold a triangle in several leaves: its parts cover it, and every ray finds what it
// finds without them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <utility>

#include "accel/accel.h"
#include "accel/kernels/dispatch.h"
#include "accel/triangle_clipper.h"
#include "accel/wide_builder.h"
#include "tests/scenes/slivers.h"

namespace dapple::test {
namespace {

constexpr std::size_t kTriangles = 6000;

WideBvh build_split(const Scene& scene) {
  return build_wide_bvh(scene, nullptr, BvhQuality::high, LeafForm::whole,
                        TriangleParts::where_they_pay);
}

bool contains(const Bounds3f& box, const Vec3d& p) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] < double{box.lo[axis]} || p[axis] > double{box.hi[axis]}) return false;
  }
  return true;
}

class Triangles {
 public:
  explicit Triangles(const Scene& scene) : scene_(scene) {}

  // Corners often, and sides.
  Vec3d point_of(std::size_t triangle) {
    double u = share(), v = share();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const auto& t = scene_.triangles[triangle].vertices;
    const auto corner = [&](std::size_t i) { return Vec3d(scene_.vertices.positions[t[i]]); };
    return corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0));
  }

 private:
  double share() {
    const double u = std::uniform_real_distribution<double>(-0.1, 1.1)(random_);
    return u < 0 ? 0 : u > 1 ? 1 : u;
  }

  const Scene& scene_;
  std::mt19937_64 random_{3};
};

class SplitTrees : public ::testing::TestWithParam<int> {
 protected:
  Slivers kind() const { return static_cast<Slivers>(GetParam()); }
};

// The boxes of the leaves that hold each triangle. Boxes above contain them.
std::multimap<PrimId, Bounds3f> boxes_of_leaves(const WideBvhView& bvh) {
  std::multimap<PrimId, Bounds3f> boxes;
  const auto box_of = [](const WideNode& node, std::size_t i) {
    return Bounds3f{{node.lo[0][i], node.lo[1][i], node.lo[2][i]},
                    {node.hi[0][i], node.hi[1][i], node.hi[2][i]}};
  };
  for (const WideNode& node : bvh.nodes) {
    for (std::size_t i = 0; i < kWideWidth; ++i) {
      const ChildRef child = node.children[i];
      if (child.is_node()) {
        const WideNode& below = bvh.nodes[child.node_index()];
        for (std::size_t k = 0; k < kWideWidth; ++k) {
          if (!below.children[k].empty()) {
            EXPECT_TRUE(box_of(node, i).contains(box_of(below, k)));
          }
        }
      }
      if (!child.is_leaf()) continue;
      PrimId before = kNoPrim;
      for (std::size_t lane = 0; lane < kLeafWidth; ++lane) {
        const PrimId id = leaf_prim_id(bvh.rows.data(), child.leaf_ref().lane(lane));
        if (id == kNoPrim) break;
        EXPECT_TRUE(lane == 0 || id > before) << "a triangle twice in one leaf";
        before = id;
        boxes.emplace(id, box_of(node, i));
      }
    }
  }
  return boxes;
}

// Whether a ray is so nearly in the plane of what it hit, or that so thin, that its distance is a
// matter of rounding.
bool is_unsure(const Scene& scene, const Ray& ray, const Hit& hit) {
  if (!hit.found()) return false;
  const auto& t = scene.triangles[hit.prim].vertices;
  const auto corner = [&](std::size_t i) { return Vec3d(scene.vertices.positions[t[i]]); };
  const Vec3d a = corner(0), b = corner(1), c = corner(2), way(ray.direction);
  const Vec3d normal = cross(b - a, c - a);
  const double longest = std::fmax(length(b - a), std::fmax(length(c - b), length(a - c)));
  const bool thin = length(normal) <= 0x1p-16 * longest * max_abs_component(a);
  return thin || std::fabs(dot(normal, way)) <= 1e-4 * length(normal) * length(way);
}

// Rays in the plane of thousands of triangles may meet another one of these. All others find the
// same.
void expect_same(const Scene& scene, Slivers kind, const std::vector<Ray>& rays,
                 const std::vector<Hit>& expected, const std::vector<Hit>& hits) {
  std::size_t differ = 0, wrong = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i] == expected[i]) continue;
    ++differ;
    wrong += !is_unsure(scene, rays[i], hits[i]) && !is_unsure(scene, rays[i], expected[i]);
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_LE(differ, rays.size() / (kind == Slivers::coplanar ? 1000 : 20'000));
}

TEST_P(SplitTrees, CoverEachPointOfEachTriangle) {
  const Scene scene = sliver_scene(kind(), kTriangles, 1);
  const WideBvh bvh = build_split(scene);
  const auto boxes = boxes_of_leaves(bvh.view());
  Triangles triangles(scene);
  std::size_t uncovered = 0;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const auto [begin, end] = boxes.equal_range(static_cast<PrimId>(i));
    for (int k = 0; k < 100; ++k) {
      const Vec3d point = triangles.point_of(i);
      uncovered += std::none_of(begin, end,
                                [&](const auto& entry) { return contains(entry.second, point); });
    }
  }
  EXPECT_EQ(uncovered, 0u);
}

TEST_P(SplitTrees, FindWhatBruteForceFinds) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Scene scene = sliver_scene(kind(), 2000, seed);
    const std::vector<Ray> rays = sliver_rays(scene, 5000, seed);
    std::vector<Hit> expected(rays.size()), hits(rays.size());
    std::vector<std::uint8_t> occluded(rays.size());
    make_accel(AccelKind::linear, scene)->intersect(rays, expected);
    const auto accel = make_accel(AccelKind::fast, scene, BvhQuality::high);
    for (const std::string_view isa : available_isas()) {
      ASSERT_TRUE(force_isa(isa));
      accel->intersect(rays, hits);
      accel->occluded(rays, occluded);
      expect_same(scene, kind(), rays, expected, hits);
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        wrong += hits[i].found() != (occluded[i] != 0);
      }
      EXPECT_EQ(wrong, 0u) << isa << ", seed " << seed;
    }
  }
  ASSERT_TRUE(force_isa(available_isas().front()));
}

// Trees of medium quality do find what brute force finds, and faster: many more rays.
TEST_P(SplitTrees, FindWhatTreesOfWholeTrianglesFind) {
  const Scene scene = sliver_scene(kind(), 20'000, 5);
  const std::vector<Ray> rays = sliver_rays(scene, 200'000, 5);
  std::vector<Hit> expected(rays.size()), hits(rays.size());
  make_accel(AccelKind::fast, scene, BvhQuality::medium)->intersect(rays, expected);
  make_accel(AccelKind::fast, scene, BvhQuality::high)->intersect(rays, hits);
  expect_same(scene, kind(), rays, expected, hits);
}

TEST_P(SplitTrees, RefittedFindTheHitsOfTheMovedScene) {
  Scene scene = sliver_scene(kind(), 2000, 9);
  WideBvh bvh = build_split(scene);
  for (Vec3f& p : scene.vertices.positions) p = Vec3f(p.y, 0.5f * p.z - p.x, p.z);
  refit_wide_bvh(scene, bvh);
  SceneView view(scene);
  view.bvh = bvh.view();
  const std::vector<Ray> rays = sliver_rays(scene, 5000, 9);
  std::vector<Hit> expected(rays.size()), hits(rays.size());
  make_accel(AccelKind::linear, scene)->intersect(rays, expected);
  make_accel(AccelKind::fast, view)->intersect(rays, hits);
  EXPECT_EQ(hits, expected);
}

INSTANTIATE_TEST_SUITE_P(Slivers, SplitTrees, ::testing::Range(0, static_cast<int>(kSliversCount)));

// Parts in the trees of prototypes, seen through instances that turn, stretch and mirror.
TEST(SplitPrototypes, FindWhatBruteForceFinds) {
  for (const Slivers kind : {Slivers::needles, Slivers::beams, Slivers::sheet, Slivers::distant}) {
    Scene scene = sliver_scene(kind, 2000, 2);
    const std::vector<Ray> rays = sliver_rays(scene, 5000, 2);
    const auto triangles = std::exchange(scene.triangles, {});
    const auto materials = std::exchange(scene.triangle_materials, {});
    scene.runs.clear();
    scene.add_prototype(triangles, materials);
    for (const float size : {1.0f, -0.7f, 1.3f}) {
      Instance instance;
      auto& rows = instance.to_world.rows;
      rows[0][0] = size;
      rows[1][1] = 0.9f;
      rows[2][0] = size - 1;
      rows[2][2] = 1;
      scene.add_instance(instance);
    }
    std::vector<Hit> expected(rays.size()), hits(rays.size());
    make_accel(AccelKind::linear, scene)->intersect(rays, expected);
    make_accel(AccelKind::fast, scene, BvhQuality::high)->intersect(rays, hits);
    EXPECT_EQ(hits, expected) << "kind " << static_cast<int>(kind);
  }
}

// Else the tests above would say nothing.
TEST(SplitTriangles, AreInSeveralLeavesAndMakeRaysVisitLess) {
  const Scene scene = sliver_scene(Slivers::beams, kTriangles, 1);
  const WideBvh bvh = build_split(scene);
  EXPECT_GT(boxes_of_leaves(bvh.view()).size(), scene.triangles.size() * 11 / 10);
  EXPECT_LT(boxes_of_leaves(bvh.view()).size(), scene.triangles.size() * 2);
  const WideBvh whole = build_wide_bvh(scene, nullptr, BvhQuality::high);
  EXPECT_EQ(boxes_of_leaves(whole.view()).size(), scene.triangles.size());
  SceneView stored(scene);
  stored.bvh = whole.view();
  const double cost = make_accel(AccelKind::fast, scene, BvhQuality::high)->stats().sah_cost;
  EXPECT_LT(cost, 0.95 * make_accel(AccelKind::fast, stored)->stats().sah_cost);
}

TEST(SplitTriangles, OnlyAtHighQuality) {
  const Scene scene = sliver_scene(Slivers::beams, kTriangles, 1);
  for (const BvhQuality quality : {BvhQuality::low, BvhQuality::medium}) {
    const WideBvh whole = build_wide_bvh(scene, nullptr, quality);
    const WideBvh parts =
        build_wide_bvh(scene, nullptr, quality, LeafForm::whole, TriangleParts::where_they_pay);
    ASSERT_EQ(parts.rows.size(), whole.rows.size());
    EXPECT_EQ(std::memcmp(parts.rows.data(), whole.rows.data(), whole.rows.bytes()), 0);
    EXPECT_EQ(std::memcmp(parts.nodes.data(), whole.nodes.data(), whole.nodes.bytes()), 0);
  }
}

// Cut, and a part of it cut again across another axis.
TEST(TriangleClipper, PartsHoldWhatIsBetweenThePlanes) {
  for (std::size_t kind = 0; kind < kSliversCount; ++kind) {
    const Scene scene = sliver_scene(static_cast<Slivers>(kind), 500, 4);
    const SceneView view(scene);
    const TriangleClipper clipper(view, scene_bounds(view));
    const HugeArray<BuildPrim> prims = make_build_prims(view, {});
    Triangles triangles(scene);
    const Bounds3f all = scene_bounds(view);
    const float little = 0x1p-15f * std::fmax(max_abs_component(all.lo), max_abs_component(all.hi));
    std::size_t outside = 0, larger = 0;
    for (std::size_t i = 0; i < prims.size(); ++i) {
      const int axis = static_cast<int>(i % 3), other = (axis + 1) % 3;
      const float lo = prims[i].lo[axis], hi = prims[i].hi[axis];
      const std::array<float, 4> planes = {lo, lo + 0.3f * (hi - lo), lo + 0.4f * (hi - lo), hi};
      std::array<Box4, 3> parts, halves;
      clipper.clip(prims[i], axis, planes, parts.data());
      BuildPrim middle = prims[i];
      const Bounds3f box = parts[1].bounds();
      middle.is_part = 1;
      for (int k = 0; k < 3; ++k) {
        middle.lo[k] = box.lo[k];
        middle.hi[k] = box.hi[k];
      }
      const float half = 0.5f * box.lo[other] + 0.5f * box.hi[other];
      const std::array<float, 3> across = {box.lo[other], half, box.hi[other]};
      if (box.lo.x <= box.hi.x) clipper.clip(middle, other, across, halves.data());
      for (int k = 0; k < 50; ++k) {
        const Vec3d at = triangles.point_of(i);
        for (std::size_t part = 0; part < 3; ++part) {
          if (at[axis] < double{planes[part]} || at[axis] > double{planes[part + 1]}) continue;
          outside += !contains(parts[part].bounds(), at);
          if (part == 1)
            outside += !contains(halves[at[other] < double{half} ? 0 : 1].bounds(), at);
        }
      }
      for (const Box4& part : parts) {
        const Bounds3f inner = part.bounds();
        if (!(inner.lo.x <= inner.hi.x)) continue;
        for (int k = 0; k < 3; ++k) {
          larger += inner.lo[k] < prims[i].lo[k] - little || inner.hi[k] > prims[i].hi[k] + little;
        }
      }
    }
    EXPECT_EQ(outside, 0u) << "kind " << kind;
    EXPECT_EQ(larger, 0u) << "kind " << kind;
  }
}

}  // namespace
}  // namespace dapple::test
