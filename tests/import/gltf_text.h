// Small glTF files, written by tests: accessors over one buffer that lies in the text.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "import/registry.h"
#include "tests/util/temporary_folder.h"

namespace dapple {

inline std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0);
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

class GltfText {
 public:
  // Each returns the number of a new accessor, or of a new view.
  template <class T>
  std::size_t view(const std::vector<T>& values, const std::string& more = "") {
    while (bytes_.size() % 4 != 0) bytes_.push_back(0);
    const std::size_t offset = bytes_.size();
    bytes_.resize(offset + values.size() * sizeof(T));
    std::memcpy(bytes_.data() + offset, values.data(), values.size() * sizeof(T));
    views_.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", offset,
                                 values.size() * sizeof(T), more));
    return views_.size() - 1;
  }
  std::size_t accessor(const std::string& json) {
    accessors_.push_back("{" + json + "}");
    return accessors_.size() - 1;
  }
  template <class T>
  std::size_t values(const std::vector<T>& numbers, const char* type, std::size_t components,
                     int component_type, const std::string& more = "") {
    return accessor(fmt::format(R"("bufferView":{},"componentType":{},"count":{},"type":"{}"{})",
                                view(numbers), component_type, numbers.size() / components, type,
                                more));
  }
  std::size_t vec3(const std::vector<float>& numbers) { return values(numbers, "VEC3", 3, 5126); }
  std::size_t vec2(const std::vector<float>& numbers) { return values(numbers, "VEC2", 2, 5126); }
  std::size_t indices(const std::vector<std::uint16_t>& numbers) {
    return values(numbers, "SCALAR", 1, 5123);
  }

  // The file; `rest` are the members of the root besides buffers and accessors.
  std::string text(const std::string& rest) const {
    const std::string data = base64(bytes_);
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{},"uri":"data:application/octet-stream;base64,{}"}}],"bufferViews":[{}],"accessors":[{}],{}}})",
        bytes_.size(), data, fmt::join(views_, ","), fmt::join(accessors_, ","), rest);
  }

 private:
  std::vector<std::uint8_t> bytes_;
  std::vector<std::string> views_;
  std::vector<std::string> accessors_;
};

// Imports a text as the file scene.gltf of a folder.
inline Expected<ImportResult> import_text(const std::string& text,
                                          const ImportOptions& options = {}) {
  const TemporaryFolder folder;
  put_file(folder / "scene.gltf", text);
  return import_scene(folder / "scene.gltf", options);
}

// One triangle in the plane z = 0, seen from +z; `node` are more members of its node.
inline std::string one_triangle(const std::string& node = "", const std::string& rest = "") {
  GltfText file;
  const auto positions = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  return file.text(fmt::format(
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],"nodes":[{{"mesh":0{}}}],"scenes":[{{"nodes":[0]}}],"scene":0{})",
      positions, node, rest));
}

}  // namespace dapple
