// Any bytes as a pbrt scene: an error or a scene, and nothing read outside its folder.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "import/model_import.h"
#include "import/pbrt/scene_reader.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

// A folder with a mesh that the scene may name.
const std::string& scene_path() {
  static const std::string path = [] {
    std::string folder = (std::filesystem::temp_directory_path() / "dapple-fuzz-XXXXXX").string();
    require(::mkdtemp(folder.data()) != nullptr);
    std::ofstream(folder + "/a.ply")
        << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
           "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    std::ofstream(folder + "/scene.pbrt") << "WorldBegin\n";
    return folder + "/scene.pbrt";
  }();
  return path;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dapple;
  ImportOptions options;
  options.max_bytes = 1 << 26;
  auto import = ModelImport::open(scene_path(), options);
  require(import.has_value());
  pbrt::SceneReader reader(*import);
  const auto read = reader.read({reinterpret_cast<const char*>(data), size}, "f.pbrt");
  if (!read) {
    require(!read.error().place.empty() && !read.error().message.empty());
    return 0;
  }
  reader.finish();
  const auto scene = import->finish();
  require(scene.has_value() || !scene.error().message.empty());
  return 0;
}
