// What a PLY file holds: a mesh, or a cloud of points.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/mesh_data.h"
#include "util/error.h"

namespace dapple::ply {

struct Model {
  MeshData mesh;                     // its materials are left empty
  std::vector<float> radii;          // of the points, where the file has them; else empty
  std::string texture_file;          // of the base colour, or empty
  std::size_t skipped_faces = 0;     // with fewer than three corners
  bool keep_going = false;           // faces with indices of nothing are left out, not an error
  std::size_t broken_faces = 0;      // so many
  std::string broken_reason;         // the first of them, with its place
  std::vector<std::string> ignored;  // elements and properties that are not understood

  bool is_cloud() const { return mesh.triangles.empty(); }
};

// `name` is the file's, for errors.
[[nodiscard]] Expected<Model> read(std::span<const std::byte> bytes, std::string_view name,
                                   bool keep_going = false);

}  // namespace dapple::ply
