// A mesh on its way into a scene.
#pragma once

#include <vector>

#include "scene/material.h"
#include "scene/mesh.h"

namespace dapple {

// Triangles index these vertices; materials[i] belongs to triangles[i].
struct MeshData {
  Vertices vertices;
  std::vector<Triangle> triangles;
  std::vector<MaterialId> materials;
};

}  // namespace dapple
