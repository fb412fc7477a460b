// Import of the formats that assimp reads: FBX, COLLADA, 3DS and others.
#pragma once

#include <string>

#include "import/import_options.h"
#include "import/import_result.h"
#include "util/error.h"

namespace dapple {

// Without assimp at build time this is an error that says so.
[[nodiscard]] Expected<ImportResult> import_with_assimp(const std::string& path,
                                                        const ImportOptions& options);

}  // namespace dapple
