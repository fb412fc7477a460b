// The vertex attributes of a primitive and of its morph targets.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "import/gltf/primitive.h"

namespace dapple::gltf {

using SharedFloats = std::shared_ptr<const FloatElements>;

// Where attributes come from: accessors, or a Draco stream. Gives nothing for a name that is not
// there.
class AttributeSource {
 public:
  virtual ~AttributeSource() = default;
  [[nodiscard]] virtual Expected<SharedFloats> floats(const std::string& name) = 0;
  [[nodiscard]] virtual Expected<std::optional<IntegerElements>> integers(
      const std::string& name) = 0;
};

// The attributes that an object such as primitive.attributes or a morph target names.
class AccessorSource : public AttributeSource {
 public:
  AccessorSource(Accessors& accessors, const JsonValue& names)
      : accessors_(accessors), names_(names) {}

  Expected<SharedFloats> floats(const std::string& name) override;
  Expected<std::optional<IntegerElements>> integers(const std::string& name) override;

 private:
  Accessors& accessors_;
  const JsonValue& names_;
};

// Positions decide the number of vertices; other attributes must have as many.
[[nodiscard]] Status read_attributes(AttributeSource& source, Primitive& primitive);
// A target of a primitive with that many vertices.
[[nodiscard]] Expected<MorphTarget> read_target(AttributeSource& source, std::size_t vertex_count);

}  // namespace dapple::gltf
