#include "import/tangents.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "math/functions.h"

namespace dapple {
namespace {

Vec3d unit_or_zero(const Vec3d& v) {
  const double norm = length(v);
  return norm > 0 && std::isfinite(norm) ? v / norm : Vec3d();
}

Vec3d without_component(const Vec3d& v, const Vec3d& n) { return unit_or_zero(v - dot(n, v) * n); }

template <class T>
std::vector<T> per_corner(const std::vector<T>& values, const std::vector<Triangle>& triangles) {
  std::vector<T> corners;
  if (values.empty()) return corners;
  corners.reserve(triangles.size() * 3);
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t vertex : triangle.vertices) corners.push_back(values[vertex]);
  }
  return corners;
}

// Gives every corner a vertex of its own with the triangle's normal.
void make_flat(Vertices& v, std::vector<Triangle>& triangles) {
  v.positions = per_corner(v.positions, triangles);
  for (auto& uvs : v.uvs) uvs = per_corner(uvs, triangles);
  v.colours = per_corner(v.colours, triangles);
  v.normals.resize(v.positions.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t first = 3 * i;
    triangles[i] = {{first, first + 1, first + 2}};
    const Vec3d a(v.positions[first]), b(v.positions[first + 1]), c(v.positions[first + 2]);
    const Vec3f normal(unit_or_zero(cross(b - a, c - a)));
    for (std::uint32_t k = 0; k < 3; ++k) v.normals[first + k] = normal;
  }
}

// For each vertex the number of the first one that equals it in position, normal and coordinates.
std::vector<std::uint32_t> welded(const Vertices& v, const std::vector<Vec2f>& uvs) {
  const auto key = [&](std::uint32_t i) {
    const Vec3f& p = v.positions[i];
    const Vec3f& n = v.normals[i];
    return std::tuple(p.x, p.y, p.z, n.x, n.y, n.z, uvs[i].x, uvs[i].y);
  };
  std::vector<std::uint32_t> order(v.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  // Bad numbers have no order; they must not reach the comparison.
  const auto is_number = [&](std::uint32_t i) { return is_finite(v.positions[i]); };
  std::vector<std::uint32_t> first = order;
  order.erase(std::stable_partition(order.begin(), order.end(), is_number), order.end());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (key(order[i - 1]) == key(order[i])) first[order[i]] = first[order[i - 1]];
  }
  return first;
}

enum Side : std::size_t { kPlain, kMirrored, kNoSide };

// The direction in which u grows over a triangle, and whether its texture is mirrored.
struct Gradient {
  Vec3d u;
  Side side = kNoSide;
};

Gradient gradient_of(const Vertices& v, const std::vector<Vec2f>& uvs, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.vertices;
  const Vec3d p1 = Vec3d(v.positions[b]) - Vec3d(v.positions[a]);
  const Vec3d p2 = Vec3d(v.positions[c]) - Vec3d(v.positions[a]);
  const double u1 = double{uvs[b].x} - uvs[a].x, v1 = double{uvs[b].y} - uvs[a].y;
  const double u2 = double{uvs[c].x} - uvs[a].x, v2 = double{uvs[c].y} - uvs[a].y;
  const double area = u1 * v2 - v1 * u2;
  if (area == 0 || !std::isfinite(area)) return {};
  // v grows downwards: the bitangent of an image that is not mirrored points against it.
  const double sign = area > 0 ? 1 : -1;
  return {unit_or_zero(sign * (v2 * p1 - v1 * p2)), area > 0 ? kMirrored : kPlain};
}

// The angle at corner k, seen along the normal there.
double angle_at(const Vertices& v, const Triangle& triangle, std::size_t k, const Vec3d& normal) {
  const Vec3d at(v.positions[triangle.vertices[k]]);
  const Vec3d next(v.positions[triangle.vertices[(k + 1) % 3]]);
  const Vec3d last(v.positions[triangle.vertices[(k + 2) % 3]]);
  return arc_cosine(
      dot(without_component(next - at, normal), without_component(last - at, normal)));
}

struct Sums {
  Vec3d tangents[2];
  bool used[2] = {false, false};
};

template <class T>
void repeat(std::vector<T>& values, std::uint32_t i) {
  if (!values.empty()) values.push_back(T(values[i]));
}

std::uint32_t copy_of_vertex(std::uint32_t i, Vertices& v) {
  repeat(v.positions, i);
  repeat(v.normals, i);
  repeat(v.tangents, i);
  for (auto& uvs : v.uvs) repeat(uvs, i);
  repeat(v.colours, i);
  return static_cast<std::uint32_t>(v.positions.size() - 1);
}

Vec4f tangent_of(const Sums& sums, Side side) {
  const Vec3f t(unit_or_zero(sums.tangents[side]));
  return {t.x, t.y, t.z, side == kPlain ? 1.0f : -1.0f};
}

}  // namespace

void make_tangents(std::uint32_t uv_set, Vertices& vertices, std::vector<Triangle>& triangles) {
  if (vertices.uvs[uv_set].empty()) return;
  vertices.tangents.clear();
  if (vertices.normals.empty()) make_flat(vertices, triangles);
  const std::vector<std::uint32_t> weld = welded(vertices, vertices.uvs[uv_set]);

  // Sum the directions of all triangles at each welded vertex, apart for the two sides.
  std::vector<Sums> sums(vertices.positions.size());
  std::vector<Side> side_of_triangle;
  for (const Triangle& triangle : triangles) {
    const Gradient gradient = gradient_of(vertices, vertices.uvs[uv_set], triangle);
    side_of_triangle.push_back(gradient.side);
    if (gradient.side == kNoSide) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangle.vertices[k];
      const Vec3d normal(vertices.normals[vertex]);
      Sums& at = sums[weld[vertex]];
      const Vec3d direction = without_component(gradient.u, normal);
      const double angle = angle_at(vertices, triangle, k, normal);
      if (!is_finite(direction) || !std::isfinite(angle)) continue;
      at.tangents[gradient.side] = at.tangents[gradient.side] + angle * direction;
      at.used[gradient.side] = true;
    }
  }

  // Each vertex keeps one side; corners of the other side get a copy.
  const auto count = static_cast<std::uint32_t>(vertices.positions.size());
  std::vector<Side> side_of_vertex(count);
  std::vector<std::uint32_t> copies(count, 0);
  vertices.tangents.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Sums& at = sums[weld[i]];
    side_of_vertex[i] = at.used[kPlain] || !at.used[kMirrored] ? kPlain : kMirrored;
    vertices.tangents[i] = tangent_of(at, side_of_vertex[i]);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t& vertex : triangles[t].vertices) {
      const Side side = side_of_triangle[t];
      if (side == kNoSide || side == side_of_vertex[vertex]) continue;
      if (copies[vertex] == 0) {
        const std::uint32_t original = vertex;
        copies[original] = copy_of_vertex(original, vertices);
        vertices.tangents.back() = tangent_of(sums[weld[original]], side);
      }
      vertex = copies[vertex];
    }
  }
}

}  // namespace dapple
