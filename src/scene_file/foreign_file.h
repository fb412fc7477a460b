// What a file that is not a scene file seems to be, for an error that helps.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace dapple {

// "it looks like a PNG image". The file must not be empty.
[[nodiscard]] std::string describe_foreign_file(std::span<const std::byte> file);

}  // namespace dapple
