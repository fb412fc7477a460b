// KHR_draco_mesh_compression, by Google's decoder.
#pragma once

#include <memory>

#include "import/gltf/attributes.h"

namespace dapple::gltf {

// The attributes that the stream of a primitive holds; those it does not hold come from accessors.
class DracoSource : public AttributeSource {
 public:
  // `draco` is the extension's object, `names` the attributes of its primitive.
  [[nodiscard]] static Expected<std::unique_ptr<DracoSource>> decode(Accessors& accessors,
                                                                     const Context& context,
                                                                     const JsonValue& draco,
                                                                     const JsonValue& names);
  // Corners of triangles.
  [[nodiscard]] virtual std::vector<std::uint32_t> take_indices() = 0;
};

}  // namespace dapple::gltf
