#include "import/pbrt/scene_reader.h"

#include <fmt/format.h>

#include "import/pbrt/lights.h"
#include "import/text.h"

namespace dapple::pbrt {
namespace {

constexpr std::size_t kMaxIncludeDepth = 16;
constexpr std::size_t kMaxIncludes = 1 << 12;

}  // namespace

const std::map<std::string_view, SceneReader::Directive>& SceneReader::directives() {
  static const std::map<std::string_view, Directive> table = {
      {"Accelerator", &SceneReader::of_the_renderer},
      {"AreaLightSource", &SceneReader::area_light_source},
      {"Attribute", &SceneReader::not_used},
      {"AttributeBegin", &SceneReader::attribute_begin},
      {"AttributeEnd", &SceneReader::attribute_end},
      {"Camera", &SceneReader::camera},
      {"ColorSpace", &SceneReader::not_used},
      {"Film", &SceneReader::film},
      {"Import", &SceneReader::include},
      {"Include", &SceneReader::include},
      {"Integrator", &SceneReader::of_the_renderer},
      {"LightSource", &SceneReader::light_source},
      {"MakeNamedMaterial", &SceneReader::make_named_material},
      {"MakeNamedMedium", &SceneReader::make_named_medium},
      {"Material", &SceneReader::material},
      {"MediumInterface", &SceneReader::medium_interface},
      {"NamedMaterial", &SceneReader::named_material},
      {"ObjectBegin", &SceneReader::object_begin},
      {"ObjectEnd", &SceneReader::object_end},
      {"ObjectInstance", &SceneReader::object_instance},
      {"Option", &SceneReader::of_the_renderer},
      {"PixelFilter", &SceneReader::of_the_renderer},
      {"ReverseOrientation", &SceneReader::reverse_orientation},
      {"Sampler", &SceneReader::of_the_renderer},
      {"Shape", &SceneReader::shape},
      {"SurfaceIntegrator", &SceneReader::of_the_renderer},
      {"Texture", &SceneReader::texture},
      {"TransformBegin", &SceneReader::attribute_begin},
      {"TransformEnd", &SceneReader::transform_end},
      {"WorldBegin", &SceneReader::world_begin},
      {"WorldEnd", &SceneReader::world_end},
  };
  return table;
}

Status SceneReader::read(std::string_view file, const std::string& file_name) {
  Lexer lexer(file, file_name);
  for (;;) {
    const auto token = lexer.next();
    if (!token) return tl::unexpected(token.error());
    if (!*token) return {};
    const std::string place = lexer.place(**token);
    if ((*token)->kind != TokenKind::word) {
      return fail(Errc::bad_data, place,
                  fmt::format("'{:.40}' stands where a directive should", (*token)->text));
    }
    if (auto done = directive((*token)->text, lexer, place); !done) return done;
  }
}

Status SceneReader::directive(std::string_view name, Lexer& lexer, const std::string& place) {
  const auto transformed = states_.transform(name, lexer);
  if (!transformed) return tl::unexpected(transformed.error());
  if (*transformed) return {};
  const auto found = directives().find(name);
  if (found == directives().end()) {
    return fail(Errc::bad_data, place, fmt::format("'{:.40}' is not a known directive", name));
  }
  name_ = name;
  return (this->*found->second)(lexer, place);
}

Expected<std::string> SceneReader::text(Lexer& lexer) {
  const auto token = lexer.next();
  if (!token) return tl::unexpected(token.error());
  if (!*token || (*token)->kind != TokenKind::text) {
    return fail(Errc::bad_data, lexer.place(), fmt::format("'{}' lacks a text", name_));
  }
  return std::string((*token)->text);
}

Status SceneReader::named(Lexer& lexer, const std::string& place, std::string& name,
                          Params& params) {
  auto given = text(lexer);
  if (!given) return tl::unexpected(given.error());
  auto list = read_params(lexer, place);
  if (!list) return tl::unexpected(list.error());
  name = std::move(*given);
  params = std::move(*list);
  return {};
}

Status SceneReader::of_the_renderer(Lexer& lexer, const std::string& place) {
  std::string name;
  Params params;
  // "Option" has no name of its own before its parameter.
  if (name_ != "Option") return named(lexer, place, name, params);
  const auto list = read_params(lexer, place);
  return list ? Status() : tl::unexpected(list.error());
}

Status SceneReader::not_used(Lexer& lexer, const std::string& place) {
  std::string name;
  Params params;
  if (auto read = named(lexer, place, name, params); !read) return read;
  if (name_ != "ColorSpace" || name != "srgb") {
    context_.warn(place, fmt::format("'{} {:.40}' is not used", name_, name));
  }
  return {};
}

Status SceneReader::attribute_begin(Lexer&, const std::string& place) {
  return states_.push(place);
}
Status SceneReader::attribute_end(Lexer&, const std::string& place) { return states_.pop(place); }
Status SceneReader::transform_end(Lexer&, const std::string& place) {
  return states_.pop_transform(place);
}

Status SceneReader::world_begin(Lexer&, const std::string& place) {
  states_.begin_world();
  const std::string& around = states_.now().outside;
  if (!around.empty()) {
    context_.warn(place, fmt::format("the medium '{:.60}' around the camera is not used", around));
    states_.now().outside.clear();
  }
  return {};
}
Status SceneReader::world_end(Lexer&, const std::string&) { return {}; }

Status SceneReader::reverse_orientation(Lexer&, const std::string&) {
  states_.now().reversed = !states_.now().reversed;
  return {};
}

Status SceneReader::camera(Lexer& lexer, const std::string& place) {
  CameraStatement statement;
  if (auto read = named(lexer, place, statement.kind, statement.params); !read) return read;
  statement.camera_from_world = states_.now().to_world;
  const double size = determinant(statement.camera_from_world);
  if (!(std::fabs(size) > 0 && std::isfinite(size))) {
    return fail(Errc::bad_data, place, "the camera's transformation has no inverse");
  }
  states_.name_system("camera", inverse(statement.camera_from_world));
  camera_ = std::move(statement);
  context_.to_scene = {};
  if (is_left_handed(camera_->camera_from_world)) context_.to_scene.rows[2][2] = -1;
  return {};
}

Status SceneReader::film(Lexer& lexer, const std::string& place) {
  std::string name;
  Params params;
  if (auto read = named(lexer, place, name, params); !read) return read;
  auto made = make_film(context_, params);
  if (!made) return tl::unexpected(made.error());
  film_ = *made;
  return {};
}

Status SceneReader::include(Lexer& lexer, const std::string& place) {
  const auto name = text(lexer);
  if (!name) return tl::unexpected(name.error());
  if (depth_ == kMaxIncludeDepth || included_ == kMaxIncludes) {
    return fail(Errc::bad_data, place, "too many included files");
  }
  const auto file = context_.import.sandbox().open(*name);
  if (!file) return fail(file.error().code, place, to_string(file.error()));
  ++depth_, ++included_;
  const Status done = read(as_text(file->bytes()), context_.import.sandbox().path_of(*name));
  --depth_;
  return done;
}

Status SceneReader::texture(Lexer& lexer, const std::string& place) {
  const auto name = text(lexer), type = text(lexer);
  if (!name || !type) return tl::unexpected((!name ? name : type).error());
  std::string kind;
  Params params;
  if (auto read = named(lexer, place, kind, params); !read) return read;
  return textures_.add(context_, *name, kind, params);
}

Status SceneReader::material(Lexer& lexer, const std::string& place) {
  std::string kind;
  Params params;
  if (auto read = named(lexer, place, kind, params); !read) return read;
  auto made = make_material(context_, textures_, kind, params);
  if (!made) return tl::unexpected(made.error());
  states_.now().material = std::move(*made);
  return {};
}

Status SceneReader::make_named_material(Lexer& lexer, const std::string& place) {
  std::string name;
  Params params;
  if (auto read = named(lexer, place, name, params); !read) return read;
  auto made = make_material(context_, textures_, params.text("type", ""), params);
  if (!made) return tl::unexpected(made.error());
  materials_[name] = std::move(*made);
  return {};
}

Status SceneReader::named_material(Lexer& lexer, const std::string& place) {
  const auto name = text(lexer);
  if (!name) return tl::unexpected(name.error());
  const auto found = materials_.find(*name);
  if (found == materials_.end()) {
    return fail(Errc::bad_data, place, fmt::format("there is no material '{:.60}'", *name));
  }
  states_.now().material = found->second;
  return {};
}

Status SceneReader::make_named_medium(Lexer& lexer, const std::string& place) {
  std::string name;
  Params params;
  if (auto read = named(lexer, place, name, params); !read) return read;
  const auto medium = make_medium(context_, params);
  if (!medium) return tl::unexpected(medium.error());
  world_.add_medium(name, *medium);
  return {};
}

// "inside" "outside", or one name for both.
Status SceneReader::medium_interface(Lexer& lexer, const std::string&) {
  const auto inside = text(lexer);
  if (!inside) return tl::unexpected(inside.error());
  auto token = lexer.next();
  if (!token) return tl::unexpected(token.error());
  states_.now().inside = states_.now().outside = *inside;
  if (*token && (*token)->kind == TokenKind::text) {
    states_.now().outside = (*token)->text;
  } else if (*token) {
    lexer.put_back(**token);
  }
  return {};
}

Status SceneReader::light_source(Lexer& lexer, const std::string& place) {
  std::string kind;
  Params params;
  if (auto read = named(lexer, place, kind, params); !read) return read;
  return add_light(context_, states_.now().to_world, kind, params);
}

Status SceneReader::area_light_source(Lexer& lexer, const std::string& place) {
  std::string kind;
  Params params;
  if (auto read = named(lexer, place, kind, params); !read) return read;
  const auto emission = area_light(context_, kind, params);
  if (!emission) return tl::unexpected(emission.error());
  states_.now().emission = *emission;
  states_.now().two_sided = params.truth("twosided", false);
  return {};
}

Status SceneReader::shape(Lexer& lexer, const std::string& place) {
  std::string kind;
  Params params;
  if (auto read = named(lexer, place, kind, params); !read) return read;
  return world_.add_shape(states_.now(), kind, params);
}

Status SceneReader::object_begin(Lexer& lexer, const std::string& place) {
  const auto name = text(lexer);
  if (!name) return tl::unexpected(name.error());
  if (auto pushed = states_.push(place); !pushed) return pushed;
  return world_.begin_object(*name, place);
}

Status SceneReader::object_end(Lexer&, const std::string& place) {
  if (auto popped = states_.pop(place); !popped) return popped;
  return world_.end_object(place);
}

Status SceneReader::object_instance(Lexer& lexer, const std::string& place) {
  const auto name = text(lexer);
  if (!name) return tl::unexpected(name.error());
  return world_.add_instance(states_.now(), *name, place);
}

void SceneReader::finish() {
  world_.finish();
  if (camera_) {
    context_.import.builder().add_camera(
        "camera", make_camera(context_, camera_->camera_from_world, camera_->kind, camera_->params,
                              film_.value_or(Film())));
  }
}

}  // namespace dapple::pbrt
