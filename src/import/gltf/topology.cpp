#include "import/gltf/topology.h"

namespace dapple::gltf {
namespace {

using Indices = std::vector<std::uint32_t>;

void assemble_lines(const Indices& v, std::uint32_t mode, Primitive& primitive) {
  const std::size_t step = mode == kLines ? 2 : 1;
  for (std::size_t i = 0; i + 1 < v.size(); i += step) primitive.lines.push_back({v[i], v[i + 1]});
  if (mode == kLineLoop && v.size() > 2) primitive.lines.push_back({v.back(), v.front()});
}

// The orders of vertices are those of the glTF specification, section 3.7.2.1: every triangle of a
// strip keeps the winding of the first.
void assemble_triangles(const Indices& v, std::uint32_t mode, Primitive& primitive) {
  const std::size_t step = mode == kTriangles ? 3 : 1;
  for (std::size_t i = 0; i + 2 < v.size(); i += step) {
    if (mode == kTriangleFan) {
      primitive.triangles.push_back({{v[i + 1], v[i + 2], v[0]}});
    } else if (mode == kTriangleStrip) {
      primitive.triangles.push_back({{v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]}});
    } else {
      primitive.triangles.push_back({{v[i], v[i + 1], v[i + 2]}});
    }
  }
}

}  // namespace

void assemble(const Indices& indices, std::uint32_t mode, Primitive& primitive) {
  if (mode == kPoints) {
    primitive.points = indices;
  } else if (mode <= kLineStrip) {
    assemble_lines(indices, mode, primitive);
  } else {
    assemble_triangles(indices, mode, primitive);
  }
}

}  // namespace dapple::gltf
