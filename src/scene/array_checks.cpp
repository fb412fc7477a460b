#include "scene/array_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/validate.h"
#include "scene/validate_looks.h"

namespace dapple {
namespace {

// The comparisons are false for NaN.
bool is_finite_number(float x) { return std::fabs(x) <= std::numeric_limits<float>::max(); }
bool is_amount(float x) { return (x >= 0) & (x <= std::numeric_limits<float>::max()); }

// 32-bit indices are compared with 32-bit limits; the last index of all is never one.
std::uint32_t index_limit(std::size_t count) {
  return static_cast<std::uint32_t>(std::min<std::size_t>(count, 0xffffffffu));
}

bool is_unit_or_zero(const Vec3f& v) {
  return ((v.x == 0) & (v.y == 0) & (v.z == 0)) | (std::fabs(dot(v, v) - 1) <= kUnitTolerance);
}

bool is_tangent(const Vec4f& t) {
  return is_unit_or_zero(t.xyz()) &
         ((std::fabs(t.w) == 1) | ((t.w == 0) & (t.x == 0) & (t.y == 0) & (t.z == 0)));
}

bool is_colour(const Vec4f& c) {
  return is_amount(c.x) & is_amount(c.y) & is_amount(c.z) & is_amount(c.w);
}

// Each begins where the one before it ends, and the last ends with the triangles.
bool is_prototype(std::span<const Prototype> all, std::size_t i, std::size_t triangle_count) {
  const auto end_of = [](const Prototype& p) {
    return std::uint64_t{p.first_triangle} + p.triangle_count;
  };
  if (all[i].triangle_count == 0 || end_of(all[i]) > triangle_count) return false;
  if (i > 0 && all[i].first_triangle != end_of(all[i - 1])) return false;
  return i + 1 < all.size() || end_of(all[i]) == triangle_count;
}

// The piece as a whole first, without a branch; the element only when there is one to be found.
template <class T, class Valid>
std::size_t scan(std::span<const T> elements, std::size_t begin, std::size_t end, Valid valid) {
  unsigned bad = 0;
  for (std::size_t i = begin; i < end; ++i) bad |= static_cast<unsigned>(!valid(elements[i]));
  if (bad == 0) return end;
  while (valid(elements[begin])) ++begin;
  return begin;
}

// The same for shapes that are nothing but coordinates, number by number.
template <class Number, class T>
std::size_t scan_coordinates(std::span<const T> elements, std::size_t begin, std::size_t end) {
  constexpr std::size_t kNumbers = sizeof(T) / sizeof(Number);
  static_assert(sizeof(T) == kNumbers * sizeof(Number));
  const auto* numbers = reinterpret_cast<const Number*>(elements.data());
  const std::size_t found =
      scan(std::span(numbers, elements.size() * kNumbers), begin * kNumbers, end * kNumbers,
           [](Number x) { return std::fabs(x) <= static_cast<Number>(kMaxCoordinate); });
  return found / kNumbers;
}

template <class Valid>
std::size_t scan_indices(std::size_t begin, std::size_t end, Valid valid) {
  while (begin < end && valid(begin)) ++begin;
  return begin;
}

}  // namespace

ArrayLimits::ArrayLimits(const SceneView& scene, std::size_t material_count)
    : materials(material_count),
      layered_materials(scene.layered_materials.size()),
      vertices(scene.vertices.positions.size()),
      triangles(scene.triangles.size()),
      prototypes(scene.prototypes.size()),
      textures(scene.textures.size()),
      images(scene.images.size()),
      texel_bytes(scene.texels.size()) {}

std::size_t first_invalid(const SceneView& scene, const ArrayLimits& limits, SceneArray array,
                          std::size_t begin, std::size_t end) {
  const auto shapes = [&](const auto& elements) {
    return scan_coordinates<double>(elements, begin, end);
  };
  const auto materials = [&](std::span<const MaterialId> ids) {
    return scan(ids, begin, end, [n = index_limit(limits.materials)](MaterialId id) {
      return static_cast<std::uint32_t>(id) < n;
    });
  };
  const auto uvs = [&](std::span<const Vec2f> all) {
    return scan(all, begin, end,
                [](Vec2f uv) { return is_finite_number(uv.x) & is_finite_number(uv.y); });
  };
  switch (array) {
    case SceneArray::spheres:
      return shapes(scene.spheres);
    case SceneArray::sphere_materials:
      return materials(scene.sphere_materials);
    case SceneArray::xy_rectangles:
      return shapes(scene.rectangles[0]);
    case SceneArray::xy_rectangle_materials:
      return materials(scene.rectangle_materials[0]);
    case SceneArray::xz_rectangles:
      return shapes(scene.rectangles[1]);
    case SceneArray::xz_rectangle_materials:
      return materials(scene.rectangle_materials[1]);
    case SceneArray::yz_rectangles:
      return shapes(scene.rectangles[2]);
    case SceneArray::yz_rectangle_materials:
      return materials(scene.rectangle_materials[2]);
    case SceneArray::positions:
      return scan_coordinates<float>(scene.vertices.positions, begin, end);
    case SceneArray::normals:
      return scan(scene.vertices.normals, begin, end, is_unit_or_zero);
    case SceneArray::tangents:
      return scan(scene.vertices.tangents, begin, end, is_tangent);
    case SceneArray::uvs0:
      return uvs(scene.vertices.uvs[0]);
    case SceneArray::uvs1:
      return uvs(scene.vertices.uvs[1]);
    case SceneArray::colours:
      return scan(scene.vertices.colours, begin, end, is_colour);
    case SceneArray::triangles:
      return scan(scene.triangles, begin, end,
                  [n = index_limit(limits.vertices)](const Triangle& t) {
                    return (t.vertices[0] < n) & (t.vertices[1] < n) & (t.vertices[2] < n);
                  });
    case SceneArray::triangle_materials:
      return materials(scene.triangle_materials);
    case SceneArray::cylinders:
      return scan(scene.cylinders, begin, end, [](const Cylinder& c) { return is_valid(c); });
    case SceneArray::cylinder_materials:
      return materials(scene.cylinder_materials);
    case SceneArray::prototypes:
      return scan_indices(begin, end, [&](std::size_t i) {
        return is_prototype(scene.prototypes, i, limits.triangles);
      });
    case SceneArray::instances:
      return scan_indices(begin, end, [&](std::size_t i) {
        return scene.instances[i].prototype < limits.prototypes &&
               is_valid(scene.instances[i].to_world);
      });
    case SceneArray::layered_materials:
      return scan_indices(begin, end, [&](std::size_t i) {
        return reason_against(scene.layered_materials[i], limits.textures).empty();
      });
    case SceneArray::textures:
      return scan_indices(
          begin, end, [&](std::size_t i) { return is_valid(scene.textures[i], limits.images); });
    case SceneArray::images:
      return scan_indices(begin, end, [&](std::size_t i) {
        return image_is_valid(scene.images, i, limits.texel_bytes);
      });
    case SceneArray::texels:
      return end;
    case SceneArray::lights:
      return scan_indices(begin, end,
                          [&](std::size_t i) { return reason_against(scene.lights[i]).empty(); });
    case SceneArray::cameras:
      return scan_indices(begin, end,
                          [&](std::size_t i) { return reason_against(scene.cameras[i]).empty(); });
  }
  return begin;
}

std::string why_invalid(const SceneView& scene, const ArrayLimits& limits, SceneArray array,
                        std::size_t index) {
  switch (array) {
    case SceneArray::spheres:
    case SceneArray::xy_rectangles:
    case SceneArray::xz_rectangles:
    case SceneArray::yz_rectangles:
    case SceneArray::positions:
      return fmt::format("a coordinate is not finite or beyond {:g}", kMaxCoordinate);
    case SceneArray::sphere_materials:
    case SceneArray::xy_rectangle_materials:
    case SceneArray::xz_rectangle_materials:
    case SceneArray::yz_rectangle_materials:
    case SceneArray::triangle_materials:
    case SceneArray::cylinder_materials:
      return fmt::format("a material id is not below {}", limits.materials);
    case SceneArray::normals:
      return "it is neither of length 1 nor zero";
    case SceneArray::tangents:
      return "it is neither of length 1 nor zero, or its sign is not 1 or -1";
    case SceneArray::uvs0:
    case SceneArray::uvs1:
      return "a coordinate is not finite";
    case SceneArray::colours:
      return "a component is negative or not finite";
    case SceneArray::triangles:
      return fmt::format("a vertex index is not below {}", limits.vertices);
    case SceneArray::cylinders:
      return fmt::format("a coordinate is not finite or beyond {:g}, or the radius is negative",
                         kMaxCoordinate);
    case SceneArray::prototypes:
      return "it has no triangles, or prototypes do not tile the last triangles";
    case SceneArray::instances:
      return scene.instances[index].prototype < limits.prototypes
                 ? "its transform is not finite, too large or cannot be inverted"
                 : "its prototype does not exist";
    case SceneArray::layered_materials:
      return reason_against(scene.layered_materials[index], limits.textures);
    case SceneArray::textures:
      return "its image does not exist, or its wrapping or filter is not known";
    case SceneArray::images:
      return "its size or format is not allowed, or images do not tile the texels";
    case SceneArray::texels:
      break;
    case SceneArray::lights:
      return reason_against(scene.lights[index]);
    case SceneArray::cameras:
      return reason_against(scene.cameras[index]);
  }
  return "it is broken";
}

}  // namespace dapple
