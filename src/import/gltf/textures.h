// The textures of a file: which picture, how it is repeated, by which coordinates it is looked up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "import/gltf/buffers.h"
#include "scene/layered_material.h"
#include "scene/mesh.h"

namespace dapple::gltf {

class Textures {
 public:
  // Decodes every picture that a material of the file uses.
  [[nodiscard]] static Expected<Textures> load(const Context& context, Buffers& buffers);

  // What a textureInfo object says; nothing when it is null.
  [[nodiscard]] Expected<TextureSlot> slot(const JsonValue& info, const std::string& pointer) const;

 private:
  explicit Textures(const Context& context) : context_(&context) {}

  const Context* context_;
  std::vector<std::optional<TextureId>> textures_;  // by the file's numbers; empty: not in use
};

}  // namespace dapple::gltf
