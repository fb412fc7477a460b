// Triangles and the vertices they share.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/transform.h"
#include "math/vec2.h"
#include "math/vec3.h"
#include "math/vec4.h"

namespace dapple {

inline constexpr std::size_t kUvSetCount = 2;

template <class T>
using OwnedArray = std::vector<T>;
template <class T>
using ArrayView = std::span<const T>;

// Attribute arrays of all vertices. Every array but `positions` is either empty or as long as it.
template <template <class> class Array>
struct VertexArrays {
  Array<Vec3f> positions;
  Array<Vec3f> normals;   // unit length, to 2.5 %; zero: that of the triangle itself
  Array<Vec4f> tangents;  // unit xyz, w = +-1 the side of the bitangent; zero: none
  std::array<Array<Vec2f>, kUvSetCount> uvs;  // (0, 0) is the corner of an image's first texel
  Array<Vec4f> colours;                       // linear, multiplied into the base colour and alpha

  friend bool operator==(const VertexArrays&, const VertexArrays&) = default;
};
using Vertices = VertexArrays<OwnedArray>;
using VertexView = VertexArrays<ArrayView>;

// Vertex indices, counter-clockwise when seen from outside.
struct Triangle {
  std::array<std::uint32_t, 3> vertices{};
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

// A solid cylinder with flat ends. The radius is not negative.
struct Cylinder {
  Vec3d begin, end;
  double radius = 0;
  friend bool operator==(const Cylinder&, const Cylinder&) = default;
};

// Triangles [first_triangle, first_triangle + triangle_count) that are seen only through instances.
// A scene's prototypes tile the tail of its triangles; those before the first stand in the world
// themselves. None is without triangles.
struct Prototype {
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
  friend bool operator==(const Prototype&, const Prototype&) = default;
};

// A prototype placed in the world, by a map that has an inverse.
struct Instance {
  Transformf to_world;
  std::uint32_t prototype = 0;
  friend bool operator==(const Instance&, const Instance&) = default;
};

}  // namespace dapple
