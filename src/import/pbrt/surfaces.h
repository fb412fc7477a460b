// Curved shapes as triangle meshes with smooth normals.
#pragma once

#include "import/mesh_data.h"

namespace dapple::pbrt {

struct SurfacePoint {
  Vec3d position, normal;
};

// A grid of columns x rows quadrilaterals over the unit square of (u, v); the normal looks to where
// u, v and it form a right-handed frame.
template <class At>
MeshData grid_mesh(std::uint32_t columns, std::uint32_t rows, At&& at) {
  MeshData mesh;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const double u = double(i) / columns, v = double(j) / rows;
      const SurfacePoint point = at(u, v);
      mesh.vertices.positions.push_back(Vec3f(point.position));
      mesh.vertices.normals.push_back(Vec3f(point.normal));
      mesh.vertices.uvs[0].push_back({static_cast<float>(u), static_cast<float>(1 - v)});
    }
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.triangles.push_back({{a, b, d}});
      mesh.triangles.push_back({{a, d, c}});
    }
  }
  return mesh;
}

}  // namespace dapple::pbrt
