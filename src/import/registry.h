// The one table of formats that can be imported, and the door to all of them.
#pragma once

#include <string>
#include <string_view>

#include "import/import_options.h"
#include "import/import_result.h"
#include "util/error.h"

namespace dapple {

// Chosen by the ending of the name; a name that ends in nothing known by the first bytes of the
// file. What is neither is an error that lists the formats.
[[nodiscard]] Expected<ImportResult> import_scene(const std::string& path,
                                                  const ImportOptions& options);

// True when the ending of the name belongs to a format that can be imported.
[[nodiscard]] bool is_importable(std::string_view path);

// ".gltf, .glb, ..." in the order of the table.
[[nodiscard]] std::string importable_endings();

}  // namespace dapple
