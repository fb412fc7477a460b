// The shapes a scene is made of, as the file says them: doubles, nothing derived.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "math/vec3.h"

namespace dapple {

// The order is that of primitive ids and of the scene file; new kinds go at the end.
enum class ShapeKind : std::uint32_t {
  sphere,
  xy_rectangle,
  xz_rectangle,
  yz_rectangle,
  triangle,
  cylinder,
  instance,
};
inline constexpr std::size_t kShapeKindCount = 7;
inline constexpr std::size_t kRectangleKindCount = 3;

// A negative radius turns the sphere inside out: its outward normal points at the centre.
struct Sphere {
  Vec3d centre;
  double radius = 0;
  friend bool operator==(const Sphere&, const Sphere&) = default;
};

// An axis-aligned rectangle: u and v are the two axes in its kind's name, in that order, and k
// is its position on the third axis.
struct Rectangle {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0, k = 0;
  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

struct RectangleAxes {
  int u, v, k;
};

// Which coordinate (0 x, 1 y, 2 z) each parameter of a rectangle kind belongs to.
constexpr RectangleAxes rectangle_axes(ShapeKind kind) {
  if (kind == ShapeKind::xy_rectangle) return {0, 1, 2};
  if (kind == ShapeKind::xz_rectangle) return {0, 2, 1};
  return {1, 2, 0};
}

constexpr bool is_rectangle(ShapeKind kind) {
  return kind >= ShapeKind::xy_rectangle && kind <= ShapeKind::yz_rectangle;
}

// Index of a rectangle kind among the rectangle kinds, and back.
constexpr std::size_t rectangle_index(ShapeKind kind) {
  return static_cast<std::size_t>(kind) - static_cast<std::size_t>(ShapeKind::xy_rectangle);
}
constexpr ShapeKind rectangle_kind(std::size_t index) {
  return static_cast<ShapeKind>(index + static_cast<std::size_t>(ShapeKind::xy_rectangle));
}

inline constexpr std::array<std::string_view, kShapeKindCount> kShapeNames = {
    "sphere", "xy_rectangle", "xz_rectangle", "yz_rectangle", "triangle", "cylinder", "instance"};

constexpr std::string_view shape_name(ShapeKind kind) {
  return kShapeNames[static_cast<std::size_t>(kind)];
}

}  // namespace dapple
