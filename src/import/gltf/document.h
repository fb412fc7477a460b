// A glTF file in memory: its JSON, its binary chunk, and the folder that its other files lie in.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "import/json_value.h"
#include "import/sandbox.h"
#include "util/error.h"
#include "util/mapped_file.h"

namespace dapple::gltf {

class Document {
 public:
  [[nodiscard]] static Expected<Document> open(const std::string& path);

  const JsonValue& root() const { return root_; }
  const JsonValue& operator[](std::string_view key) const { return root_[key]; }
  std::optional<std::span<const std::byte>> bin() const { return bin_; }
  // The text begins with a byte order mark, which glTF forbids.
  bool has_mark() const { return has_mark_; }
  const Sandbox& folder() const { return folder_; }

  // "FILE, /meshes/0": where the errors and warnings about a JSON pointer lie.
  std::string place(const std::string& pointer) const;
  [[nodiscard]] tl::unexpected<Error> error(const std::string& pointer, std::string message) const;

 private:
  Document(std::string path, MappedFile file, Sandbox folder)
      : path_(std::move(path)), file_(std::move(file)), folder_(std::move(folder)) {}

  std::string path_;
  MappedFile file_;
  Sandbox folder_;
  JsonValue root_;
  bool has_mark_ = false;
  std::optional<std::span<const std::byte>> bin_;
};

}  // namespace dapple::gltf
