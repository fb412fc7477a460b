// glTF's materials with their extensions, as layered materials.
#pragma once

#include <map>
#include <optional>

#include "import/gltf/nodes.h"
#include "import/gltf/textures.h"
#include "math/vec4.h"

namespace dapple::gltf {

class Materials {
 public:
  Materials(const Context& context, const Textures& textures)
      : context_(context), textures_(textures) {}

  // The material of a primitive, with the variant that the options choose.
  [[nodiscard]] Expected<LayeredMaterial> of_primitive(const JsonValue& primitive,
                                                       const std::string& pointer);

 private:
  [[nodiscard]] Expected<LayeredMaterial> read(std::uint32_t index) const;

  const Context& context_;
  const Textures& textures_;
  std::map<std::uint32_t, LayeredMaterial> known_;
};

// The materials of all primitives that these nodes show, under the variant that the options choose.
[[nodiscard]] std::set<std::uint32_t> materials_in_use(const Context& context,
                                                       const std::vector<PlacedNode>& nodes);

// True when a material looks at the direction of the texture coordinates on the surface.
bool needs_tangents(const LayeredMaterial& material);
// The coordinates that those directions belong to.
std::uint32_t tangent_uv_set(const LayeredMaterial& material);

// The variant that the options ask for must be one of the file's.
[[nodiscard]] Status check_variant(const Context& context);

}  // namespace dapple::gltf
