// References from a glTF file: to other files, or data within the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "util/error.h"

namespace dapple::gltf {

struct DataUri {
  std::string_view media_type;
  std::vector<std::uint8_t> bytes;
};

bool is_data_uri(std::string_view uri);
[[nodiscard]] Expected<DataUri> decode_data_uri(std::string_view uri);

// The name of a file from a relative reference: %20 and the like decoded. A reference with a scheme
// or host is an error.
[[nodiscard]] Expected<std::string> file_of_uri(std::string_view uri);

}  // namespace dapple::gltf
