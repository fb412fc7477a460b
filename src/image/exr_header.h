// The header of an EXR file, checked before OpenEXR sees it.
#pragma once

#include <cstddef>
#include <span>

#include "util/error.h"

namespace dapple {

// Whether every attribute (name, type, size, value) lies in the file and has the size that its type
// must have. OpenEXR trusts counts inside a value and may read on beyond its size, then takes what
// it meets there as sizes to make room for; in a header that passes here it cannot.
[[nodiscard]] Status check_exr_header(std::span<const std::byte> bytes);

}  // namespace dapple
