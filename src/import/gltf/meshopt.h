// EXT_meshopt_compression, by meshoptimizer.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "import/json_value.h"
#include "import/limits.h"

namespace dapple::gltf {

// `extension` is the extension's object of a buffer view, `bytes` what it refers to.
[[nodiscard]] Expected<std::vector<std::byte>> unpack_meshopt(const JsonValue& extension,
                                                              std::span<const std::byte> bytes,
                                                              ByteBudget& budget);

}  // namespace dapple::gltf
