#include "scene/prims.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "scene/leaf.h"

namespace dapple {
namespace {

float to_float(double x) { return static_cast<float>(x); }

}  // namespace

// The same operations on the same floats as the own-box rule uses (intersect_scalar.h).
Bounds3f sphere_bounds(const Sphere& sphere) {
  const Vec3f c(sphere.centre);
  const float r = std::fabs(to_float(sphere.radius));
  return {{c.x - r, c.y - r, c.z - r}, {c.x + r, c.y + r, c.z + r}};
}

Bounds3f rectangle_bounds(ShapeKind kind, const Rectangle& r) {
  const RectangleAxes axes = rectangle_axes(kind);
  Bounds3f box;
  box.lo[axes.u] = to_float(r.u0);
  box.hi[axes.u] = to_float(r.u1);
  box.lo[axes.v] = to_float(r.v0);
  box.hi[axes.v] = to_float(r.v1);
  box.lo[axes.k] = box.hi[axes.k] = to_float(r.k);
  return box;
}

Bounds3f triangle_bounds(const SceneView& scene, const Triangle& triangle) {
  Bounds3f box;
  for (const std::uint32_t vertex : triangle.vertices) {
    const Vec3f& position = scene.vertices.positions[vertex];
    box.extend({position, position});
  }
  return box;
}

Bounds3f shape_bounds(const SceneView& scene, ShapeKind kind, std::size_t index) {
  if (kind == ShapeKind::sphere) return sphere_bounds(scene.spheres[index]);
  if (kind == ShapeKind::triangle) return triangle_bounds(scene, scene.triangles[index]);
  return rectangle_bounds(kind, scene.rectangles[rectangle_index(kind)][index]);
}

Bounds3f scene_bounds(const SceneView& scene) {
  Bounds3f all;
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    for (std::size_t i = 0; i < scene.object_count(kind); ++i) {
      all.extend(shape_bounds(scene, kind, i));
    }
  }
  return all;
}

void clear_leaf(ShapeKind kind, LeafRow* leaf) {
  std::fill_n(leaf, leaf_rows(kind), LeafRow{});
  std::fill_n(leaf[leaf_id_row(kind)].words, kLeafWidth, kNoPrim);
  if (!is_rectangle(kind)) return;
  std::fill_n(leaf[0].words, kLeafWidth, std::bit_cast<std::uint32_t>(Bounds3f::kInfinity));
  std::fill_n(leaf[1].words, kLeafWidth, std::bit_cast<std::uint32_t>(-Bounds3f::kInfinity));
}

void write_lane(const SceneView& scene, ShapeKind kind, std::size_t index, PrimId id, LeafRow* leaf,
                std::size_t lane) {
  LeafRow* row = leaf;
  const auto put = [&](double value) {
    row++->words[lane] = std::bit_cast<std::uint32_t>(to_float(value));
  };
  if (kind == ShapeKind::sphere) {
    const Sphere& s = scene.spheres[index];
    for (const double value : {s.centre.x, s.centre.y, s.centre.z, s.radius}) put(value);
  } else if (kind == ShapeKind::triangle) {
    for (const std::uint32_t vertex : scene.triangles[index].vertices) {
      const Vec3f& p = scene.vertices.positions[vertex];
      for (const float value : {p.x, p.y, p.z}) put(double{value});
    }
  } else {
    const Rectangle& r = scene.rectangles[rectangle_index(kind)][index];
    for (const double value : {r.u0, r.u1, r.v0, r.v1, r.k}) put(value);
  }
  row->words[lane] = id;
}

}  // namespace dapple
