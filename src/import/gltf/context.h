// What every part of the glTF importer has at hand.
#pragma once

#include <string>

#include "import/gltf/document.h"
#include "import/import_log.h"
#include "import/import_options.h"
#include "import/scene_builder.h"

namespace dapple::gltf {

struct Context {
  const Document& document;
  const ImportOptions& options;
  SceneBuilder& builder;
  ImportLog& log;

  void warn(const std::string& pointer, const std::string& message) const {
    log.warn(document.place(pointer) + ": " + message);
  }
  // An error that keep_going turns into a warning.
  [[nodiscard]] Status tolerate(const Error& error) const {
    if (!options.keep_going) return tl::unexpected(error);
    log.warn(to_string(error));
    return {};
  }
};

}  // namespace dapple::gltf
