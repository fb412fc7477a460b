#include "tests/import/mesh_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "math/functions.h"

namespace dapple {
namespace {

template <class T>
void append(std::string& bytes, T value, bool big_endian) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big_endian) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

const Vec3f& position(const MeshData& mesh, const Triangle& triangle, int corner) {
  return mesh.vertices.positions[triangle.vertices[static_cast<std::size_t>(corner)]];
}

std::string ply_header(const MeshData& mesh, ply::Format format) {
  const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  return fmt::format(
      "ply\nformat {} 1.0\ncomment made by a test\nelement vertex {}\nproperty float x\nproperty "
      "float y\nproperty float z\nelement face {}\nproperty list uchar int vertex_indices\n"
      "end_header\n",
      names[static_cast<int>(format)], mesh.vertices.positions.size(), mesh.triangles.size());
}

}  // namespace

MeshData bumpy_torus(std::uint32_t side) {
  MeshData mesh;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const auto around = sin_cos_turns(static_cast<float>(i / side) / static_cast<float>(side));
    const auto across = sin_cos_turns(static_cast<float>(i % side) / static_cast<float>(side));
    const float bump = 0.3f + 0.01f * static_cast<float>(i * 2654435761u % 7);
    mesh.vertices.positions.emplace_back((1 + bump * across.cos) * around.cos, bump * across.sin,
                                         (1 + bump * across.cos) * around.sin);
  }
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t k = (i + 1) % side, l = (j + 1) % side;
      mesh.triangles.push_back({{i * side + j, i * side + l, k * side + j}});
      mesh.triangles.push_back({{k * side + j, i * side + l, k * side + l}});
    }
  }
  return mesh;
}

std::string as_obj(const MeshData& mesh) {
  std::string text = "# a test\n";
  for (const Vec3f& p : mesh.vertices.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const Triangle& t : mesh.triangles) {
    text += fmt::format("f {} {} {}\n", t.vertices[0] + 1, t.vertices[1] + 1, t.vertices[2] + 1);
  }
  return text;
}

std::string as_ply(const MeshData& mesh, ply::Format format) {
  std::string text = ply_header(mesh, format);
  const bool ascii = format == ply::Format::ascii, big = format == ply::Format::big_endian;
  for (const Vec3f& p : mesh.vertices.positions) {
    if (ascii) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    for (int axis = 0; axis < 3 && !ascii; ++axis) append(text, p[axis], big);
  }
  for (const Triangle& t : mesh.triangles) {
    if (ascii) text += fmt::format("3 {} {} {}\n", t.vertices[0], t.vertices[1], t.vertices[2]);
    if (ascii) continue;
    append(text, std::uint8_t{3}, big);
    for (const std::uint32_t vertex : t.vertices) append(text, vertex, big);
  }
  return text;
}

std::string as_stl_text(const MeshData& mesh) {
  std::string text = "solid test\n";
  for (const Triangle& t : mesh.triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (int i = 0; i < 3; ++i) {
      const Vec3f& p = position(mesh, t, i);
      text += fmt::format("      vertex {} {} {}\n", p.x, p.y, p.z);
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid test\n";
}

std::string as_stl_binary(const MeshData& mesh) {
  std::string bytes = "solid, and yet binary";
  bytes.resize(80);
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()), false);
  for (const Triangle& t : mesh.triangles) {
    bytes.append(12, '\0');
    for (int i = 0; i < 9; ++i) append(bytes, position(mesh, t, i / 3)[i % 3], false);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::vector<std::byte> as_bytes(const std::string& text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

std::vector<std::array<Vec3f, 3>> corner_positions(const MeshData& mesh) {
  std::vector<std::array<Vec3f, 3>> corners;
  for (const Triangle& t : mesh.triangles) {
    corners.push_back({position(mesh, t, 0), position(mesh, t, 1), position(mesh, t, 2)});
  }
  return corners;
}

}  // namespace dapple
