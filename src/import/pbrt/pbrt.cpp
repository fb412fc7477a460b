#include "import/pbrt/pbrt.h"

#include "import/model_import.h"
#include "import/pbrt/scene_reader.h"
#include "import/text.h"

namespace dapple {

Expected<ImportResult> import_pbrt(const std::string& path, const ImportOptions& options) {
  auto import = ModelImport::open(path, options);
  if (!import) return tl::unexpected(import.error());
  pbrt::SceneReader reader(*import);
  if (auto read = reader.read(as_text(import->bytes()), path); !read) {
    const Error& error = read.error();
    return fail(error.code, error.place.empty() ? path : error.place, error.message);
  }
  reader.finish();
  auto result = import->finish();
  if (result && reader.film())
    result->pictures.resolution = {reader.film()->width, reader.film()->height};
  return result;
}

}  // namespace dapple
