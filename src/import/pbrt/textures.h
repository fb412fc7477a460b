// Textures of a pbrt scene.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "import/pbrt/context.h"
#include "scene/layered_material.h"

namespace dapple::pbrt {

// A factor, times what a picture shows if there is one.
struct SurfaceTexture {
  Vec3f factor{1, 1, 1};
  TextureSlot slot;

  bool has_picture() const { return slot.texture != kNoTexture; }
};

class Textures {
 public:
  // "constant", "scale", "checkerboard" of constants and "imagemap"; others become their mean or
  // grey with a warning.
  [[nodiscard]] Status add(const Context& context, const std::string& name, const std::string& kind,
                           const Params& params);

  // The parameter `name` as a texture or a colour; nothing if it is not there.
  [[nodiscard]] Expected<std::optional<SurfaceTexture>> find(const Context& context,
                                                             const Params& params,
                                                             std::string_view name) const;
  // The same for a number; a picture counts as its factor, with a warning.
  [[nodiscard]] Expected<double> number(const Context& context, const Params& params,
                                        std::string_view name, double otherwise) const;

 private:
  std::map<std::string, SurfaceTexture> textures_;
};

}  // namespace dapple::pbrt
