// One primitive of a mesh, read but not yet posed: its vertices in the space of the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "import/gltf/accessors.h"
#include "scene/mesh.h"

namespace dapple::gltf {

// What a morph target adds to each vertex; an array may be empty.
struct MorphTarget {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec3f> tangents;
  std::array<std::vector<Vec2f>, kUvSetCount> uvs;
  std::vector<Vec4f> colours;
};

// Joint numbers and weights of all vertices, `per_vertex` of each.
struct Influences {
  std::size_t per_vertex = 0;
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

struct Primitive {
  Vertices vertices;
  Influences influences;
  std::vector<MorphTarget> targets;
  // Exactly one of these is filled.
  std::vector<Triangle> triangles;
  std::vector<std::array<std::uint32_t, 2>> lines;
  std::vector<std::uint32_t> points;
  std::vector<std::string> doubts;  // about its attributes: warnings to be
};

// One without positions is empty. Vertices that nothing uses are left out.
[[nodiscard]] Expected<Primitive> read_primitive(Accessors& accessors, const Context& context,
                                                 const JsonValue& json, const std::string& pointer);

}  // namespace dapple::gltf
