// STL files, both kinds.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/mesh_data.h"
#include "util/error.h"

namespace dapple::stl {

struct Model {
  MeshData mesh;  // equal positions are one vertex; its materials are left empty
  std::vector<std::string> warnings;
};

// A file of exactly the size that its binary header promises is binary, whatever its first word;
// else one that begins with "solid" is text. `name` is the file's, for errors.
[[nodiscard]] Expected<Model> read(std::span<const std::byte> bytes, std::string_view name);

}  // namespace dapple::stl
