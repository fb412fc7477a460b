// The same mesh written in each of the simple formats.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "import/mesh_data.h"
#include "import/ply/header.h"

namespace dapple {

// A closed surface of `side` x `side` quadrilaterals cut in two, with irregular positions.
MeshData bumpy_torus(std::uint32_t side);

std::string as_obj(const MeshData& mesh);
std::string as_ply(const MeshData& mesh, ply::Format format);
std::string as_stl_text(const MeshData& mesh);
std::string as_stl_binary(const MeshData& mesh);

std::vector<std::byte> as_bytes(const std::string& text);

// The three positions of each triangle.
std::vector<std::array<Vec3f, 3>> corner_positions(const MeshData& mesh);

}  // namespace dapple
