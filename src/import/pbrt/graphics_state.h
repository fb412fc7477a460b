// What shapes and lights of a pbrt scene are made under.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/pbrt/lexer.h"
#include "math/transform.h"
#include "scene/layered_material.h"

namespace dapple::pbrt {

struct GraphicsState {
  Transformd to_world;  // the current transformation
  std::optional<LayeredMaterial> material;
  std::optional<Vec3f> emission;  // of an area light
  bool two_sided = false;         // that light
  bool reversed = false;
  std::string inside, outside;  // media
};

// The stack of states, and the directives that change the transformation.
class GraphicsStates {
 public:
  static constexpr std::size_t kMaxDepth = 1 << 16;

  GraphicsState& now() { return now_; }
  const GraphicsState& now() const { return now_; }

  [[nodiscard]] Status push(const std::string& place);
  [[nodiscard]] Status pop(const std::string& place);
  // Only the transformation comes back.
  [[nodiscard]] Status pop_transform(const std::string& place);

  // True when `directive` is one of these; its numbers are read from the lexer.
  [[nodiscard]] Expected<bool> transform(std::string_view directive, Lexer& lexer);

  // What CoordSysTransform finds under that name.
  void name_system(const std::string& name, const Transformd& to_world) {
    systems_[name] = to_world;
  }
  // What is true at the beginning of the world: no transformation, everything else stays.
  void begin_world();

 private:
  [[nodiscard]] Expected<bool> named_system(std::string_view directive, Lexer& lexer);

  GraphicsState now_;
  std::vector<GraphicsState> stack_;
  std::map<std::string, Transformd> systems_;
};

}  // namespace dapple::pbrt
