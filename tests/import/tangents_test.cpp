// Tangents point where u grows, share across smooth edges, and split where a texture is mirrored.
#include "import/tangents.h"

#include <gtest/gtest.h>

namespace dapple {
namespace {

// Two triangles of a square in z = 0; `mirrored` turns the u of the second one back.
Vertices square(bool mirrored) {
  Vertices v;
  v.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}};
  v.normals.assign(4, {0, 0, 1});
  v.uvs[0] = {{0, 1}, {1, 1}, {1, 0}, {mirrored ? 0.0f : 2.0f, 1}};
  return v;
}
const std::vector<Triangle> kSquare = {{{0, 1, 2}}, {{1, 3, 2}}};

TEST(Tangents, FollowTheGrowthOfU) {
  Vertices v = square(false);
  auto triangles = kSquare;
  make_tangents(0, v, triangles);
  ASSERT_EQ(v.positions.size(), 4u);
  for (const Vec4f& t : v.tangents) EXPECT_EQ(t, (Vec4f{1, 0, 0, 1}));
}

TEST(Tangents, MirroredHalvesDoNotShareVertices) {
  Vertices v = square(true);
  auto triangles = kSquare;
  make_tangents(0, v, triangles);
  EXPECT_EQ(v.positions.size(), 6u);
  for (const std::uint32_t i : triangles[0].vertices) EXPECT_EQ(v.tangents[i], (Vec4f{1, 0, 0, 1}));
  for (const std::uint32_t i : triangles[1].vertices) {
    EXPECT_EQ(v.tangents[i], (Vec4f{-1, 0, 0, -1}));
    EXPECT_EQ(v.normals[i], Vec3f(0, 0, 1));
  }
}

TEST(Tangents, DoNotDependOnHowVerticesAreShared) {
  Vertices shared = square(false);
  shared.positions[3] = {2, 0, 1};  // a bent edge, so that averaging shows
  shared.normals = {{0, 0, 1}, {-0.6f, 0, 0.8f}, {-0.6f, 0, 0.8f}, {-0.6f, 0, 0.8f}};
  Vertices apart;
  std::vector<Triangle> own;
  for (const Triangle& triangle : kSquare) {
    const auto first = static_cast<std::uint32_t>(apart.positions.size());
    own.push_back({{first, first + 1, first + 2}});
    for (const std::uint32_t i : triangle.vertices) {
      apart.positions.push_back(shared.positions[i]);
      apart.normals.push_back(shared.normals[i]);
      apart.uvs[0].push_back(shared.uvs[0][i]);
    }
  }
  auto triangles = kSquare;
  make_tangents(0, shared, triangles);
  make_tangents(0, apart, own);
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(shared.tangents[triangles[t].vertices[k]], apart.tangents[own[t].vertices[k]]);
    }
  }
}

TEST(Tangents, MissingNormalsAreThoseOfTheTriangles) {
  Vertices v = square(false);
  v.normals.clear();
  auto triangles = kSquare;
  make_tangents(0, v, triangles);
  ASSERT_EQ(v.normals.size(), 6u);
  for (const Vec3f& n : v.normals) EXPECT_EQ(n, Vec3f(0, 0, 1));
}

}  // namespace
}  // namespace dapple
