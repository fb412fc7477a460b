#include "import/assimp/assimp.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <exception>

#include "import/assimp/materials.h"
#include "import/assimp/nodes.h"
#include "import/assimp/sandbox_files.h"
#include "import/model_import.h"

namespace dapple {
namespace {

// Its validation proves every index before anything here uses one.
constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                            aiProcess_ValidateDataStructure | aiProcess_GenUVCoords;

Expected<ImportResult> import(ModelImport& import, const std::string& path) {
  Assimp::Importer importer;
  importer.SetIOHandler(new assimp::SandboxFiles(import.sandbox()));  // which it deletes
  const std::size_t slash = path.rfind('/');
  const aiScene* scene =
      importer.ReadFile(slash == std::string::npos ? path : path.substr(slash + 1), kSteps);
  if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0) {
    const std::string reason = importer.GetErrorString();
    return fail(Errc::bad_data, path, reason.empty() ? "cannot be read by assimp" : reason);
  }
  const auto materials = assimp::add_materials(*scene, import);
  if (!materials) return tl::unexpected(materials.error());
  if (auto added = assimp::add_nodes(*scene, *materials, import); !added) {
    const Error& error = added.error();
    return fail(error.code, error.place.empty() ? path : error.place, error.message);
  }
  return import.finish();
}

}  // namespace

Expected<ImportResult> import_with_assimp(const std::string& path, const ImportOptions& options) {
  auto opened = ModelImport::open(path, options);
  if (!opened) return tl::unexpected(opened.error());
  try {
    return import(*opened, path);
  } catch (const std::bad_alloc&) {
    throw;  // reported as what it is
  } catch (const std::exception& e) {
    return fail(Errc::bad_data, path, e.what());
  }
}

}  // namespace dapple
