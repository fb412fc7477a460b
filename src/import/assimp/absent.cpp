// In place of the import through assimp where the build found none.
#include "import/assimp/assimp.h"

namespace dapple {

Expected<ImportResult> import_with_assimp(const std::string& path, const ImportOptions&) {
  return fail(Errc::bad_data, path,
              "this format is read through assimp, and this dapple was built without it");
}

}  // namespace dapple
