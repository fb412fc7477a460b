// The textures of a file: which picture, how it is repeated, by which coordinates it is looked up.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "import/gltf/buffers.h"
#include "scene/layered_material.h"
#include "scene/mesh.h"

namespace dapple::gltf {

class Textures {
 public:
  // Decodes every picture that the surfaces of these materials show.
  [[nodiscard]] static Expected<Textures> load(const Context& context, Buffers& buffers,
                                               const std::set<std::uint32_t>& materials);

  // The images that were asked for, by the file's numbers.
  const std::set<std::uint32_t>& images() const { return images_; }

  // What a textureInfo object says; nothing when it is null.
  [[nodiscard]] Expected<TextureSlot> slot(const JsonValue& info, const std::string& pointer) const;

 private:
  explicit Textures(const Context& context) : context_(&context) {}

  const Context* context_;
  std::set<std::uint32_t> images_;
  std::vector<std::optional<TextureId>> textures_;  // by the file's numbers; empty: not in use
};

}  // namespace dapple::gltf
