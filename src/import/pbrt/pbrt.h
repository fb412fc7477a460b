// Import of scenes of pbrt-v4.
#pragma once

#include <string>

#include "import/import_options.h"
#include "import/import_result.h"
#include "util/error.h"

namespace dapple {

[[nodiscard]] Expected<ImportResult> import_pbrt(const std::string& path,
                                                 const ImportOptions& options);

}  // namespace dapple
