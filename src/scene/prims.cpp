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

// Around the balls at both ends.
Bounds3f cylinder_bounds(const Cylinder& cylinder) {
  const Vec3f a(cylinder.begin), b(cylinder.end);
  const float r = std::fabs(to_float(cylinder.radius));
  Bounds3f box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = (a[axis] < b[axis] ? a[axis] : b[axis]) - r;
    box.hi[axis] = (a[axis] > b[axis] ? a[axis] : b[axis]) + r;
  }
  return box;
}

// A little larger than the corners say: rays are rounded when they enter the prototype's space.
Bounds3f instance_bounds(const Transformf& to_world, const Bounds3f& prototype) {
  constexpr float kPad = 0x1p-20f;
  const bool empty = !(prototype.lo.x <= prototype.hi.x);
  Bounds3f box;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3d at;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = (corner >> axis & 1) != 0;
      at[axis] = empty ? 0 : double{upper ? prototype.hi[axis] : prototype.lo[axis]};
    }
    const Vec3f in_world(to_world.point(at));
    box.extend({in_world, in_world});
  }
  for (int axis = 0; axis < 3; ++axis) {
    const float pad = kPad * std::fmax(std::fabs(box.lo[axis]), std::fabs(box.hi[axis]));
    box.lo[axis] -= pad;
    box.hi[axis] += pad;
  }
  return box;
}

PrototypeBoxes prototype_boxes(const SceneView& scene) {
  PrototypeBoxes boxes;
  boxes.reserve(scene.prototypes.size());
  for (const Prototype& prototype : scene.prototypes) {
    Bounds3f& box = boxes.emplace_back();
    const auto of = scene.triangles.subspan(prototype.first_triangle, prototype.triangle_count);
    for (const Triangle& triangle : of) box.extend(triangle_bounds(scene, triangle));
  }
  return boxes;
}

Bounds3f shape_bounds(const SceneView& scene, const PrototypeBoxes& prototypes, ShapeKind kind,
                      std::size_t index) {
  if (kind == ShapeKind::sphere) return sphere_bounds(scene.spheres[index]);
  if (kind == ShapeKind::triangle) return triangle_bounds(scene, scene.triangles[index]);
  if (kind == ShapeKind::cylinder) return cylinder_bounds(scene.cylinders[index]);
  if (kind == ShapeKind::instance) {
    const Instance& instance = scene.instances[index];
    return instance_bounds(instance.to_world, prototypes[instance.prototype]);
  }
  return rectangle_bounds(kind, scene.rectangles[rectangle_index(kind)][index]);
}

Bounds3f scene_bounds(const SceneView& scene) {
  const PrototypeBoxes prototypes = prototype_boxes(scene);
  Bounds3f all;
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    for (std::size_t i = 0; i < scene.object_count(kind); ++i) {
      all.extend(shape_bounds(scene, prototypes, kind, i));
    }
  }
  return all;
}

void clear_leaf(ShapeKind kind, LeafRow* leaf, LeafForm form) {
  constexpr auto kInfinity = std::bit_cast<std::uint32_t>(Bounds3f::kInfinity);
  constexpr auto kMinusInfinity = std::bit_cast<std::uint32_t>(-Bounds3f::kInfinity);
  std::fill_n(leaf, leaf_rows(kind, form), LeafRow{});
  std::fill_n(leaf[leaf_id_row(kind, form)].words, kLeafWidth, kNoPrim);
  if (is_rectangle(kind)) {
    std::fill_n(leaf[0].words, kLeafWidth, kInfinity);
    std::fill_n(leaf[1].words, kLeafWidth, kMinusInfinity);
  }
  if (kind != ShapeKind::instance) return;
  for (std::size_t row = 0; row < 6; ++row) {
    std::fill_n(leaf[row].words, kLeafWidth, row < 3 ? kInfinity : kMinusInfinity);
  }
}

void write_lane(const SceneView& scene, const PrototypeBoxes& prototypes, ShapeKind kind,
                std::size_t index, PrimId id, LeafRow* leaf, std::size_t lane, LeafForm form) {
  LeafRow* row = leaf;
  const auto put = [&](float value) { row++->words[lane] = std::bit_cast<std::uint32_t>(value); };
  const auto put_point = [&](const Vec3f& p) {
    for (const float value : {p.x, p.y, p.z}) put(value);
  };
  if (kind == ShapeKind::sphere) {
    const Sphere& s = scene.spheres[index];
    put_point(Vec3f(s.centre));
    put(to_float(s.radius));
  } else if (kind == ShapeKind::triangle) {
    for (const std::uint32_t vertex : scene.triangles[index].vertices) {
      if (form == LeafForm::compact) {
        row++->words[lane] = vertex;
      } else {
        put_point(scene.vertices.positions[vertex]);
      }
    }
  } else if (kind == ShapeKind::cylinder) {
    const Cylinder& c = scene.cylinders[index];
    put_point(Vec3f(c.begin));
    put_point(Vec3f(c.end));
    put(to_float(c.radius));
  } else if (kind == ShapeKind::instance) {
    const Bounds3f box = shape_bounds(scene, prototypes, kind, index);
    put_point(box.lo);
    put_point(box.hi);
  } else {
    const Rectangle& r = scene.rectangles[rectangle_index(kind)][index];
    for (const double value : {r.u0, r.u1, r.v0, r.v1, r.k}) put(to_float(value));
  }
  row->words[lane] = id;
}

}  // namespace dapple
