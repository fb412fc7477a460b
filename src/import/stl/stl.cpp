#include "import/stl/stl.h"

#include "import/default_material.h"
#include "import/model_import.h"
#include "import/stl/reader.h"

namespace dapple {

Expected<ImportResult> import_stl(const std::string& path, const ImportOptions& options) {
  auto import = ModelImport::open(path, options);
  if (!import) return tl::unexpected(import.error());
  auto model = stl::read(import->bytes(), path);
  if (!model) return tl::unexpected(model.error());
  for (std::string& warning : model->warnings) import->log().warn(std::move(warning));
  MeshData& mesh = model->mesh;
  mesh.materials.assign(mesh.triangles.size(), import->builder().add_material(default_material()));
  if (auto added = import->builder().add_mesh(mesh); !added) {
    return fail(added.error().code, path, added.error().message);
  }
  return import->finish();
}

}  // namespace dapple
