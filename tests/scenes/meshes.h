// Closed meshes for tests.
#pragma once

#include "math/vec3.h"
#include "scene/scene.h"

namespace dapple::test {

// Where a cube stands and how it is divided.
struct CubeMesh {
  Vec3f centre;
  float size = 1;       // half its side
  int divisions = 8;    // along each edge
  float roundness = 0;  // 0 a cube, 1 a sphere
  float bumps = 0;      // relative height of random displacements
};

// Appends the triangles of the mesh, facing outwards, all with one material. Neighbours share
// vertices: it has no holes.
void add_cube_mesh(const CubeMesh& mesh, MaterialId material, Scene& scene);

}  // namespace dapple::test
