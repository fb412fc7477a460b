// Shapes of a pbrt scene as meshes, in their own space.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "import/mesh_data.h"
#include "import/pbrt/context.h"

namespace dapple::pbrt {

// A mesh whose triangles turn counter-clockwise around pbrt's normal.
struct Shape {
  MeshData mesh;                 // its materials are left empty
  std::optional<double> radius;  // of a whole sphere around the origin; then the mesh is empty
};

class Shapes {
 public:
  // Nothing, with a warning, for a shape that is not understood.
  [[nodiscard]] Expected<std::optional<Shape>> make(const Context& context, const std::string& kind,
                                                    const Params& params);

 private:
  [[nodiscard]] Expected<Shape> ply_mesh(const Context& context, const Params& params);

  std::map<std::string, MeshData> files_;  // scenes place the same mesh many times
};

// Smooth and closed, for spheres that a transform makes something else.
[[nodiscard]] MeshData sphere_mesh(double radius);

// Moves a mesh from its own space into the world. Its triangles turn the other way if exactly one
// of `reversed` and a mirroring transform is the case, so that outside stays outside.
[[nodiscard]] Status place(const Transformd& to_world, bool reversed, MeshData& mesh);

}  // namespace dapple::pbrt
