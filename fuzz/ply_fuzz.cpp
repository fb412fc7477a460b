// Any bytes as a PLY file: an error or a model whose indices hold.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "import/ply/model.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto model = dapple::ply::read({reinterpret_cast<const std::byte*>(data), size}, "f.ply");
  if (!model) {
    require(!model.error().place.empty() && !model.error().message.empty());
    return 0;
  }
  const auto& vertices = model->mesh.vertices;
  const std::size_t count = vertices.positions.size();
  require(count <= size && model->mesh.triangles.size() <= size);
  for (const auto& triangle : model->mesh.triangles) {
    for (const std::uint32_t vertex : triangle.vertices) require(vertex < count);
  }
  require(vertices.normals.empty() || vertices.normals.size() == count);
  require(vertices.colours.empty() || vertices.colours.size() == count);
  require(vertices.uvs[0].empty() || vertices.uvs[0].size() == count);
  require(model->radii.empty() || model->radii.size() == count);
  return 0;
}
