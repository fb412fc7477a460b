// Any bytes as an STL file: an error or a mesh whose indices hold.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "import/stl/reader.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto model = dapple::stl::read({reinterpret_cast<const std::byte*>(data), size}, "f.stl");
  if (!model) {
    require(!model.error().place.empty() && !model.error().message.empty());
    return 0;
  }
  require(model->mesh.triangles.size() <= size);
  for (const auto& triangle : model->mesh.triangles) {
    for (const std::uint32_t vertex : triangle.vertices) {
      require(vertex < model->mesh.vertices.positions.size());
    }
  }
  return 0;
}
