// Any bytes as an OBJ file, then as a material library: an error or a mesh that a scene takes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "import/obj/geometry.h"
#include "import/obj/mesh.h"
#include "import/obj/mtl.h"
#include "import/obj/smoothing.h"
#include "import/scene_builder.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dapple;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (auto geometry = obj::read_geometry(text, "f.obj")) {
    obj::add_smooth_normals(*geometry);
    MeshData mesh = obj::build_mesh(*geometry);
    SceneBuilder builder(1 << 26);
    mesh.materials.assign(mesh.triangles.size(), builder.add_material({}));
    require(builder.add_mesh(mesh).has_value());
    require(builder.finish("").has_value());
  } else {
    require(!geometry.error().place.empty() && !geometry.error().message.empty());
  }
  obj::MtlLibrary library;
  const auto read = obj::read_mtl(text, "f.mtl", library);
  require(read.has_value() || !read.error().place.empty());
  return 0;
}
