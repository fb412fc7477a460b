// The directives of a pbrt scene, one after the other.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "import/pbrt/camera.h"
#include "import/pbrt/graphics_state.h"
#include "import/pbrt/world.h"

namespace dapple::pbrt {

class SceneReader {
 public:
  explicit SceneReader(ModelImport& import) : context_{import, {}}, world_(context_) {}

  [[nodiscard]] Status read(std::string_view text, const std::string& name);
  // What comes of the whole: camera and environment.
  void finish();

  const std::optional<Film>& film() const { return film_; }

 private:
  // A directive takes what it needs from the lexer.
  using Directive = Status (SceneReader::*)(Lexer&, const std::string& place);
  static const std::map<std::string_view, Directive>& directives();

  [[nodiscard]] Status directive(std::string_view name, Lexer& lexer, const std::string& place);
  // The text after a directive, and the parameters after that.
  [[nodiscard]] Expected<std::string> text(Lexer& lexer);
  [[nodiscard]] Status named(Lexer& lexer, const std::string& place, std::string& name,
                             Params& params);

  Status area_light_source(Lexer&, const std::string&);
  Status attribute_begin(Lexer&, const std::string&);
  Status attribute_end(Lexer&, const std::string&);
  Status camera(Lexer&, const std::string&);
  Status film(Lexer&, const std::string&);
  Status include(Lexer&, const std::string&);
  Status light_source(Lexer&, const std::string&);
  Status make_named_material(Lexer&, const std::string&);
  Status make_named_medium(Lexer&, const std::string&);
  Status material(Lexer&, const std::string&);
  Status medium_interface(Lexer&, const std::string&);
  Status named_material(Lexer&, const std::string&);
  Status object_begin(Lexer&, const std::string&);
  Status object_end(Lexer&, const std::string&);
  Status object_instance(Lexer&, const std::string&);
  Status reverse_orientation(Lexer&, const std::string&);
  Status shape(Lexer&, const std::string&);
  Status texture(Lexer&, const std::string&);
  Status transform_end(Lexer&, const std::string&);
  Status world_begin(Lexer&, const std::string&);
  Status world_end(Lexer&, const std::string&);
  Status of_the_renderer(Lexer&, const std::string&);
  Status not_used(Lexer&, const std::string&);

  struct CameraStatement {
    std::string kind;
    Params params;
    Transformd camera_from_world;
  };

  Context context_;
  World world_;
  Textures textures_;
  GraphicsStates states_;
  std::map<std::string, LayeredMaterial> materials_;
  std::optional<CameraStatement> camera_;
  std::optional<Film> film_;
  std::size_t depth_ = 0;     // of included files
  std::size_t included_ = 0;  // files
  std::string name_;          // of the directive at work
};

}  // namespace dapple::pbrt
