// Shapes of a pbrt scene on their way into the scene, singly or as objects that are placed often.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "import/pbrt/context.h"
#include "import/pbrt/graphics_state.h"
#include "import/pbrt/materials.h"
#include "import/pbrt/shapes.h"

namespace dapple::pbrt {

class World {
 public:
  explicit World(Context& context) : context_(context) {}

  void add_medium(const std::string& name, const Medium& medium) { media_[name] = medium; }
  [[nodiscard]] Status add_shape(const GraphicsState& state, const std::string& kind,
                                 const Params& params);

  [[nodiscard]] Status begin_object(const std::string& name, const std::string& place);
  [[nodiscard]] Status end_object(const std::string& place);
  [[nodiscard]] Status add_instance(const GraphicsState& state, const std::string& name,
                                    const std::string& place);

  // Warns of media that fill nothing.
  void finish();

 private:
  [[nodiscard]] MaterialId material_of(const GraphicsState& state, const Params& params);
  [[nodiscard]] Status add_sphere(const GraphicsState& state, double radius, MaterialId material);
  [[nodiscard]] Status add_mesh(const Transformd& to_scene, bool reversed, MaterialId material,
                                MeshData mesh);

  Context& context_;
  Shapes shapes_;
  std::map<std::string, Medium> media_;
  std::set<std::string> filling_;                   // media that are inside of something
  std::map<std::string, std::string> surrounding_;  // and outside, with the first place
  std::map<std::string, std::uint32_t> objects_;    // the number of their prototype
  std::optional<MeshData> object_;                  // the one that is being described
  std::string object_name_;
};

}  // namespace dapple::pbrt
